// SPDX-License-Identifier: Apache-2.0
// Comparisons, one sentence each.
#include "tests/fuzz/shots/findings.h"

#include <algorithm>
#include <sstream>

namespace demolish::fuzz {
namespace {

constexpr double kLeastClosure = 0.98, kMostClosure = 1.02;
/// Of the bodies' weight times their height: what stands still and sags a little brings in less.
constexpr double kLeastShare = 1e-3;

/// Knobs are options, or keys of a scene file.
bool namesAKnob(const std::string& status) {
    return status.find("impact velocity") != std::string::npos ||
           status.find("substeps") != std::string::npos;
}

void compareHashes(const ShotRun& alone, const ShotRun& watched, std::vector<Finding>& findings) {
    if (alone.frames != watched.frames)
        findings.push_back({"hash", "alone it took " + std::to_string(alone.frames) + " frames, watched " +
                                        std::to_string(watched.frames)});
    const size_t both = std::min(alone.hashes.size(), watched.hashes.size());
    for (size_t k = 0; k < both; ++k) {
        if (alone.hashes[k] == watched.hashes[k]) continue;
        std::ostringstream text;
        text << "moment " << k + 1 << " of " << both << " has state " << std::hex << alone.hashes[k]
             << " alone and " << watched.hashes[k] << " watched";
        findings.push_back({"hash", text.str()});
        return;
    }
}

void checkBooks(const ShotRun& run, std::vector<Finding>& findings) {
    const bool tells = run.brought_in > kLeastShare * run.weight_energy;
    if (!tells || (run.closure >= kLeastClosure && run.closure <= kMostClosure)) return;
    std::ostringstream text;
    text.precision(4);
    text << "the books close to " << run.closure << " of " << run.brought_in << " J";
    findings.push_back({"books", text.str()});
}

}  // namespace

std::vector<Finding> findingsOf(const ShotRun& alone, const ShotRun& watched) {
    std::vector<Finding> findings;
    if (alone.refused != watched.refused)
        findings.push_back({"refusal", "alone: '" + alone.refused + "', watched: '" + watched.refused + "'"});
    for (const ShotRun* run : {&alone, &watched}) {
        for (const auto& fault : run->faults)
            findings.push_back({fault.starts_with("frame") ? "frame" : "body", fault});
        if (!run->stopped.empty() && !namesAKnob(run->stopped))
            findings.push_back({"status", "names no knob: '" + run->stopped + "'"});
    }
    compareHashes(alone, watched, findings);
    checkBooks(watched, findings);
    return findings;
}

}  // namespace demolish::fuzz
