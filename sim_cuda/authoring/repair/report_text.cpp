// SPDX-License-Identifier: Apache-2.0
// Names of modes, and the report in words.
#include <algorithm>
#include <cstdio>

#include "sim_cuda/api/mesh_repair.h"

namespace demolish {
namespace {

std::string counted(size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string metres(double length) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g m", length);
    return text;
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
    return text;
}

const char* wordsOf(RemeshCause cause) {
    switch (cause) {
        case RemeshCause::kNone:
            break;
        case RemeshCause::kAsked:
            return "as asked";
        case RemeshCause::kStillOpen:
            return "since its holes could not be closed otherwise";
        case RemeshCause::kWallsOfSolid:
            return "since its loose faces bound a solid";
        case RemeshCause::kInsideOut:
            return "since parts of it lay inside out";
        case RemeshCause::kCells:
            return "since its cells could not be closed otherwise";
    }
    return "";
}

}  // namespace

std::vector<std::string> repairModeNames() {
    return {"auto", "exact", "remesh", "off"};  // in order of RepairMode
}

std::string repairModeName(RepairMode mode) {
    return repairModeNames().at(size_t(mode));
}

std::optional<RepairMode> repairModeOf(const std::string& name) {
    const std::vector<std::string> names = repairModeNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return RepairMode(found - names.begin());
}

std::vector<std::string> repairLines(const RepairReport& report) {
    std::vector<std::string> lines;
    if (report.untouched) return lines;
    if (report.welded > 0) lines.push_back(counted(report.welded, "vertex", "vertices") + " welded");
    if (report.doubles > 0)
        lines.push_back(counted(report.doubles, "doubled triangle", "doubled triangles") + " dropped");
    if (report.walls > 0) lines.push_back(counted(report.walls, "inner wall", "inner walls") + " dropped");
    if (report.turned_triangles > 0)
        lines.push_back(counted(report.turned_triangles, "triangle", "triangles") + " turned");
    if (report.turned_parts > 0)
        lines.push_back(counted(report.turned_parts, "part", "parts") + " turned outside out");
    if (report.cavities > 0) lines.push_back(counted(report.cavities, "hollow", "hollows") + " kept");
    const bool is_new =
        report.remeshed == RemeshCause::kStillOpen || report.remeshed == RemeshCause::kWallsOfSolid;
    if (report.holes > 0 && !is_new)
        lines.push_back(counted(report.holes, "hole", "holes") + " filled (the longest of " +
                        counted(report.longest_hole, "edge", "edges") + ")");
    if (report.sheets > 0 && !is_new)
        lines.push_back(counted(report.sheets, "sheet", "sheets") + " made " + metres(report.thickness) +
                        " thick");
    if (report.united > 0)
        lines.push_back(counted(report.united, "part", "parts") + " united, which overlapped by " +
                        percent(report.overlap) + " of the volume");
    if (report.remeshed != RemeshCause::kNone)
        lines.push_back(std::string("a new surface made, ") + wordsOf(report.remeshed));
    if (lines.empty()) lines.push_back("vertices put in order");
    return lines;
}

std::string repairSentence(const RepairReport& report) {
    std::string sentence;
    for (const std::string& line : repairLines(report)) sentence += (sentence.empty() ? "" : "; ") + line;
    return sentence;
}

}  // namespace demolish
