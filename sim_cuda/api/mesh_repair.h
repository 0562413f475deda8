// SPDX-License-Identifier: Apache-2.0
// How a model file that is not a closed mesh is made one, and what was done to it.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace demolish {

enum class RepairMode {
    kAuto,    ///< as far as needed; what cannot be closed as it is gets a new surface
    kExact,   ///< never a new surface: closed by caps and thickness, or refused
    kRemesh,  ///< a new surface, also of closed models
    kOff,     ///< refused unless closed
};

/// As on the command line and in scene files: "auto", "exact", "remesh", "off".
std::vector<std::string> repairModeNames();
std::string repairModeName(RepairMode mode);
std::optional<RepairMode> repairModeOf(const std::string& name);

struct RepairOptions {
    RepairMode mode = RepairMode::kAuto;
    double thickness = 0;  ///< m, of sheets; 0: chosen by their area

    bool operator==(const RepairOptions&) const = default;
};

/// Why the surface is a new one.
enum class RemeshCause { kNone, kAsked, kStillOpen, kWallsOfSolid, kInsideOut, kCells };

struct RepairReport {
    // the file, vertices of equal position being one
    size_t triangles = 0, vertices = 0;
    size_t open_edges = 0;
    size_t parts = 0;  ///< joined by edges
    // what was done
    size_t welded = 0;                   ///< vertices that went into one close by
    size_t doubles = 0;                  ///< triangles that were there twice
    size_t walls = 0;                    ///< inner walls dropped, patches
    size_t turned_triangles = 0;         ///< to agree with their neighbours
    size_t turned_parts = 0;             ///< their outside out
    size_t cavities = 0;                 ///< parts that stay hollows in others
    size_t holes = 0, longest_hole = 0;  ///< filled; edges of the longest border
    size_t sheets = 0;                   ///< parts that were given a thickness
    double thickness = 0;                ///< m, of the thickest of them
    double overlap = 0;                  ///< of the volume, counted more than once before parts were united
    size_t united = 0;                   ///< parts that went into one surface with others
    RemeshCause remeshed = RemeshCause::kNone;
    size_t triangles_after = 0;

    /// The mesh is the file's, bit for bit.
    bool untouched = true;
};

/// What was done, a line for each step that did something; none for a mesh that was left alone.
std::vector<std::string> repairLines(const RepairReport& report);
/// The same in one sentence; "" for a mesh that was left alone.
std::string repairSentence(const RepairReport& report);

}  // namespace demolish
