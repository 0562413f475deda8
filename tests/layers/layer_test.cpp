// SPDX-License-Identifier: Apache-2.0
// Reads every include line and fails on an arrow that the architecture forbids, on files and functions that
// grew too long, and on habits that would break the equal bits of CPU and GPU.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {
namespace fs = std::filesystem;
const fs::path kRoot = DEMOLISH_SOURCE_DIR;

/// Which rooms (longest matching prefix) a room may include, besides itself and the system.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"sim_cuda/api", {}},
    {"sim_cuda/physics", {}},
    {"sim_cuda/authoring", {"sim_cuda/api", "sim_cuda/physics"}},
    {"sim_cuda/backend", {"sim_cuda/api/errors.h", "sim_cuda/physics/function.h"}},
    {"sim_cuda/data", {"sim_cuda/backend", "sim_cuda/physics", "sim_cuda/api"}},
    {"sim_cuda/kernels", {"sim_cuda/physics", "sim_cuda/data", "sim_cuda/backend", "sim_cuda/api"}},
    {"sim_cuda/solver",
     {"sim_cuda/api", "sim_cuda/physics", "sim_cuda/data", "sim_cuda/kernels", "sim_cuda/backend"}},
    {"sim_cuda/bench", {"sim_cuda/api", "sim_cuda/physics", "sim_cuda/data", "sim_cuda/backend"}},
    {"engine/gl", {"engine"}},
    {"engine/platform", {"engine"}},
    {"engine/scene", {"engine"}},
    {"engine/render", {"engine"}},
    {"engine/passes", {"engine"}},
    {"engine/image", {"engine"}},
    {"app/bridge", {"engine", "sim_cuda/api"}},
    {"app/process", {}},
    {"app/session", {"app/bridge", "engine", "sim_cuda/api"}},
    {"app/panel", {"app/session", "engine", "sim_cuda/api"}},
    {"app/commands", {"app", "engine", "sim_cuda/api"}},
    {"app", {"app", "engine", "sim_cuda/api"}},
    {"assets/models", {}},
};

/// System headers that only some rooms may see.
struct GuardedHeader {
    std::regex pattern;
    std::vector<std::string> allowed_in;
};
const std::vector<GuardedHeader> kGuarded = {
    {std::regex(R"(cuda_gl_interop\.h)"), {"app/bridge"}},
    {std::regex(R"(^(cuda|cub/|thrust/|cooperative_groups|device_launch))"),
     {"sim_cuda/backend", "sim_cuda/kernels", "sim_cuda/solver", "sim_cuda/bench", "app/bridge"}},
    {std::regex(R"(^(GL|EGL|glad|GLFW)/)"), {"engine", "app/bridge", "app/commands", "app/panel"}},
    {std::regex(R"(imgui)"), {"app/panel", "app/commands"}},
    {std::regex(R"(^assimp/)"), {"sim_cuda/authoring"}},
};

bool startsWith(const std::string& text, const std::string& prefix) {
    return text == prefix || text.rfind(prefix + "/", 0) == 0;
}

bool isSource(const fs::path& file) {
    static const std::set<std::string> kExtensions = {".h", ".hpp", ".cpp", ".cu", ".cuh"};
    return kExtensions.count(file.extension().string()) > 0;
}

std::vector<fs::path> sourcesUnder(const std::vector<std::string>& folders) {
    std::vector<fs::path> files;
    for (const auto& folder : folders) {
        if (!fs::exists(kRoot / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
            if (entry.is_regular_file() && isSource(entry.path())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> linesOf(const fs::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string roomOf(const std::string& relative) {
    std::string best;
    for (const auto& [room, allowed] : kMayInclude)
        if (startsWith(relative, room) && room.size() > best.size()) best = room;
    return best;
}

std::string complaintAbout(const std::string& room, const std::string& header) {
    const bool ours = header.rfind("sim_cuda/", 0) == 0 || header.rfind("engine/", 0) == 0 ||
                      header.rfind("app/", 0) == 0 || header.rfind("assets/", 0) == 0;
    if (ours) {
        if (startsWith(header, room)) return "";
        for (const auto& allowed : kMayInclude.at(room))
            if (startsWith(header, allowed)) return "";
        return room + " may not include " + header;
    }
    for (const auto& guarded : kGuarded) {
        if (!std::regex_search(header, guarded.pattern)) continue;
        const bool allowed = std::any_of(guarded.allowed_in.begin(), guarded.allowed_in.end(),
                                         [&](const auto& place) { return startsWith(room, place); });
        if (!allowed) return room + " may not include <" + header + ">";
    }
    return "";
}

std::vector<std::string> forbiddenArrows(const std::string& room, const std::vector<std::string>& lines) {
    static const std::regex kInclude(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    std::vector<std::string> complaints;
    std::smatch match;
    for (const auto& line : lines)
        if (std::regex_search(line, match, kInclude))
            if (const auto complaint = complaintAbout(room, match[1]); !complaint.empty())
                complaints.push_back(complaint);
    return complaints;
}
}  // namespace

TEST(Layers, EveryIncludeGoesTheWayOfTheData) {
    const auto files = sourcesUnder({"sim_cuda", "engine", "app", "assets"});
    ASSERT_GT(files.size(), 50u);
    for (const auto& file : files) {
        const auto relative = fs::relative(file, kRoot).generic_string();
        const auto room = roomOf(relative);
        ASSERT_FALSE(room.empty()) << relative << " stands in no room of the architecture";
        for (const auto& complaint : forbiddenArrows(room, linesOf(file)))
            ADD_FAILURE() << relative << ": " << complaint;
    }
}

TEST(Layers, TheRuleItselfCatchesForbiddenArrows) {
    EXPECT_FALSE(forbiddenArrows("engine/render", {R"(#include "sim_cuda/api/solver.h")"}).empty());
    EXPECT_FALSE(forbiddenArrows("sim_cuda/api", {"#include <cuda_runtime.h>"}).empty());
    EXPECT_FALSE(forbiddenArrows("sim_cuda/solver", {"#include <cuda_gl_interop.h>"}).empty());
    EXPECT_FALSE(forbiddenArrows("app/session", {"#include <imgui.h>"}).empty());
    EXPECT_TRUE(
        forbiddenArrows("app/bridge", {"#include <cuda_gl_interop.h>", R"(#include "engine/gl/buffer.h")"})
            .empty());
}

TEST(Layers, FilesStayUnder400Lines) {
    for (const auto& file : sourcesUnder({"sim_cuda", "engine", "app", "assets", "tests"}))
        EXPECT_LE(linesOf(file).size(), 400u) << fs::relative(file, kRoot);
}

TEST(Layers, NothingBreaksTheEqualBits) {
    const std::regex habits(
        R"(use_fast_math|ffast-math|atomicAdd\s*\(\s*\(?\s*float|\bfminf\b|\bfmaxf\b|\brsqrtf\b|__sinf|__expf)");
    for (const auto& file : sourcesUnder({"sim_cuda"})) {
        const auto lines = linesOf(file);
        for (size_t i = 0; i < lines.size(); ++i) {
            const auto code = lines[i].substr(0, lines[i].find("//"));
            EXPECT_FALSE(std::regex_search(code, habits)) << fs::relative(file, kRoot) << ":" << i + 1;
        }
    }
}
