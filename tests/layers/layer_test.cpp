// SPDX-License-Identifier: Apache-2.0
// Reads every include line and fails on an arrow that the architecture forbids, and on a system header that a
// file reaches by whatever way through ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/layers/source_tree.h"

namespace demolish::layers {
namespace {

/// Which rooms (longest matching prefix) a room may include, besides itself and the system.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"sim_cuda/api", {}},
    {"sim_cuda/physics", {}},
    {"sim_cuda/authoring", {"sim_cuda/api", "sim_cuda/physics", "sim_cuda/patterns"}},
    {"sim_cuda/backend", {"sim_cuda/api/errors.h", "sim_cuda/physics/function.h"}},
    {"sim_cuda/data", {"sim_cuda/backend", "sim_cuda/physics", "sim_cuda/api"}},
    {"sim_cuda/kernels", {"sim_cuda/physics", "sim_cuda/data", "sim_cuda/backend", "sim_cuda/api"}},
    {"sim_cuda/effects",
     {"sim_cuda/api", "sim_cuda/physics", "sim_cuda/data", "sim_cuda/backend",
      "sim_cuda/kernels/fragment_sums.h"}},
    {"sim_cuda/patterns",
     {"sim_cuda/api", "sim_cuda/physics", "sim_cuda/data", "sim_cuda/backend", "sim_cuda/kernels"}},
    {"sim_cuda/solver",
     {"sim_cuda/api", "sim_cuda/physics", "sim_cuda/data", "sim_cuda/kernels", "sim_cuda/backend",
      "sim_cuda/effects", "sim_cuda/patterns"}},
    {"sim_cuda/bench", {"sim_cuda/api", "sim_cuda/physics", "sim_cuda/data", "sim_cuda/backend"}},
    {"engine/gl", {"engine"}},
    {"engine/platform", {"engine"}},
    {"engine/scene", {"engine"}},
    {"engine/render", {"engine"}},
    {"engine/surroundings", {"engine"}},
    {"engine/looks", {"engine"}},
    {"engine/passes", {"engine"}},
    {"engine/image", {"engine"}},
    {"app/bridge", {"engine", "sim_cuda/api"}},
    {"app/process", {}},
    {"app/reading", {"app/process", "sim_cuda/api"}},
    {"app/session", {"app/bridge", "app/reading", "engine", "sim_cuda/api"}},
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
    {std::regex(R"(^Imf)"), {"engine/surroundings"}},
    {std::regex(R"(^stb/)"), {"engine/surroundings", "engine/looks", "sim_cuda/authoring"}},
};

bool startsWith(const std::string& text, const std::string& prefix) {
    return text == prefix || text.rfind(prefix + "/", 0) == 0;
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
    std::vector<std::string> complaints;
    for (const std::string& header : includesIn(lines))
        if (const auto complaint = complaintAbout(room, header); !complaint.empty())
            complaints.push_back(complaint);
    return complaints;
}

/// What files may not reach, however many headers lie between: plain values stay plain.
struct Unreachable {
    std::regex header;
    std::regex from;  ///< names of files
};
const std::vector<Unreachable> kUnreachable = {
    {std::regex(R"(^(GL|EGL|glad|GLFW)/)"),
     std::regex(
         R"(^(sim_cuda|assets|engine/scene|engine/surroundings|engine/image|app/calibrate|app/breakage)/|^app/session/.*\.h$)")},
    {std::regex(R"(^(cuda|cub/|thrust/|cooperative_groups))"),
     std::regex(
         R"(^(sim_cuda/(api|physics|authoring)|engine|assets|app/(session|calibrate|breakage|panel|commands))/)")},
    {std::regex(R"(imgui)"),
     std::regex(R"(^(sim_cuda|engine|assets|app/(session|bridge|calibrate|breakage))/)")},
    {std::regex(R"(^assimp/)"),
     std::regex(R"(^(engine|assets|app|sim_cuda/(api|physics|backend|data|kernels|solver))/)")},
};

/// Files by name, with what each includes.
using Includes = std::map<std::string, std::vector<std::string>>;

Includes includesOfAll() {
    Includes all;
    for (const auto& file : sourcesUnder({"sim_cuda", "engine", "app", "assets"}))
        all[nameOf(file)] = includesIn(linesOf(file));
    return all;
}

/// "a.h > b.h > glad/gl.h" for each header that `file` reaches and may not.
std::vector<std::string> forbiddenReaches(const std::string& file, const Includes& all) {
    std::vector<std::string> complaints;
    std::set<std::string> seen{file};
    std::vector<std::pair<std::string, std::string>> next{{file, file}};  // file, and the way to it
    for (size_t k = 0; k < next.size(); ++k) {
        const auto [name, way] = next[k];
        const auto found = all.find(name);
        if (found == all.end()) {
            for (const Unreachable& rule : kUnreachable)
                if (std::regex_search(name, rule.header) && std::regex_search(file, rule.from))
                    complaints.push_back(way);
            continue;
        }
        for (const std::string& header : found->second)
            if (seen.insert(header).second) next.emplace_back(header, way + " > " + header);
    }
    return complaints;
}
}  // namespace

TEST(Layers, EveryIncludeGoesTheWayOfTheData) {
    const auto files = sourcesUnder({"sim_cuda", "engine", "app", "assets"});
    ASSERT_GT(files.size(), 50u);
    for (const auto& file : files) {
        const auto relative = nameOf(file);
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

TEST(Layers, NobodyReachesByDetoursWhatIsNotTheirs) {
    const Includes all = includesOfAll();
    for (const auto& [file, headers] : all)
        for (const std::string& way : forbiddenReaches(file, all)) ADD_FAILURE() << way;
}

TEST(Layers, TheRuleItselfFollowsDetours) {
    const Includes all = {{"app/session/shot.h", {"engine/scene/look.h"}},
                          {"engine/scene/look.h", {"engine/gl/object.h", "app/session/shot.h"}},
                          {"engine/gl/object.h", {"glad/gl.h"}},
                          {"app/session/show.cpp", {"engine/gl/object.h"}}};
    EXPECT_EQ(forbiddenReaches("app/session/shot.h", all),
              std::vector<std::string>{
                  "app/session/shot.h > engine/scene/look.h > engine/gl/object.h > glad/gl.h"});
    EXPECT_TRUE(forbiddenReaches("app/session/show.cpp", all).empty());
}

}  // namespace demolish::layers
