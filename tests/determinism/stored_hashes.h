// SPDX-License-Identifier: Apache-2.0
// The file of state hashes: written by one machine, checked by all.
#pragma once
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace demolish::tests {

inline std::string hashFile() {
    return std::string(DEMOLISH_SOURCE_DIR) + "/tests/determinism/hashes.json";
}

inline std::string asHex(uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

/// Hashes of `scene` as hexadecimal text; empty when none are stored.
inline std::vector<std::string> storedHashes(const std::string& scene) {
    std::ifstream in(hashFile());
    if (!in) return {};
    return nlohmann::json::parse(in).value(scene, std::vector<std::string>{});
}

inline void storeHashes(const std::string& scene, const std::vector<std::string>& hashes) {
    nlohmann::json file = nlohmann::json::object();
    if (std::ifstream in(hashFile()); in) file = nlohmann::json::parse(in);
    file[scene] = hashes;
    std::ofstream(hashFile()) << file.dump(2) << '\n';
}

}  // namespace demolish::tests
