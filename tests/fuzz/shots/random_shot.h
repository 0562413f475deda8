// SPDX-License-Identifier: Apache-2.0
// A shot out of a seed: what is broken and how, when a person fires, and how it is watched.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/shot_options.h"

namespace demolish::fuzz {

/// What looks at a run. None of it may change a bit of what is simulated.
struct Watching {
    unsigned threads = 1;
    uint32_t every = 1;          ///< frames between two looks
    bool ledger = false;         ///< damping and friction are booked
    bool measure = false;        ///< energies and momenta, as the window's panel asks for them
    bool draw_geometry = false;  ///< cells can be drawn
    bool frames = false;         ///< whole frames are exported, with colours, as for a recording
    bool record = false;         ///< by the session itself, into GL's buffers
    bool restore = false;        ///< a snapshot, some frames more, and back to it

    std::string inWords() const;
};

/// A ball fired by hand between two frames, from outside of the bodies as they stood at first.
struct HandShot {
    uint64_t after_frame = 0;
    Double3 side;    ///< any length: where the ball comes from
    Double3 astray;  ///< how far it misses the middle, in radii of a sphere round all bodies
};

struct RandomShot {
    ShotOptions options;
    std::optional<double> first_impact;  ///< s; set: balls come earlier than the scene says
    uint64_t frames = 1;
    std::vector<HandShot> by_hand;
    Watching watching;  ///< of the second run; the first runs alone, on one thread
    double cost = 0;    ///< particles x substeps of one run, settling included

    /// What makeShot() makes of it, with its balls brought forward.
    Shot shot() const;
    /// Can `demolish bench` show the same? It fires no balls by hand and lets them come when the scene says.
    bool isForBench() const { return !first_impact && by_hand.empty(); }
    /// Its arguments: the same shot, or the same but for that.
    std::vector<std::string> benchWords() const;
};

struct RandomShotLimits {
    double cost = 3e6;             ///< particles x substeps that a run may take
    double most_particles = 5000;  ///< of all bodies
    bool may_record = false;       ///< there is OpenGL
    bool sets = false;             ///< scenes of several bodies (random_set.h)
    std::string device = "cpu";
};

/// The `index`-th shot of `seed`; its model or scene is written to `models`.
RandomShot randomShot(uint64_t seed, uint64_t index, const RandomShotLimits& limits,
                      const std::filesystem::path& models);

}  // namespace demolish::fuzz
