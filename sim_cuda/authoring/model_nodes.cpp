// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/model_nodes.h"

#include <algorithm>
#include <map>

#include "sim_cuda/authoring/model_refusal.h"

namespace demolish {
namespace {

constexpr size_t kMostNamed = 20;    // in a sentence
constexpr size_t kMostOfAName = 60;  // bytes, there
constexpr const char* kNameless = "node";

class Naming {
  public:
    void add(const aiNode& node) {
        const std::string own = node.mName.length > 0 ? node.mName.C_Str() : kNameless;
        const size_t count = ++count_[own];
        nodes_.push_back({count == 1 ? own : own + "#" + std::to_string(count), &node});
        for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i]);
    }
    std::vector<NamedNode> take() && { return std::move(nodes_); }

  private:
    std::map<std::string, size_t> count_;
    std::vector<NamedNode> nodes_;
};

}  // namespace

std::vector<NamedNode> namedNodes(const aiNode& root) {
    Naming naming;
    naming.add(root);
    return std::move(naming).take();
}

const aiNode& requireNode(const aiNode& root, const std::string& name, const std::filesystem::path& file) {
    const std::vector<NamedNode> nodes = namedNodes(root);
    const auto at =
        std::find_if(nodes.begin(), nodes.end(), [&](const NamedNode& node) { return node.name == name; });
    if (at != nodes.end()) return *at->node;
    std::string names;
    size_t listed = 0, more = 0;
    for (const NamedNode& node : nodes) {
        if (node.node->mNumMeshes == 0) continue;
        if (listed == kMostNamed) {
            ++more;
            continue;
        }
        names += (listed++ == 0 ? "" : ", ") + node.name.substr(0, kMostOfAName);
    }
    if (more > 0) names += " and " + std::to_string(more) + " more";
    refuseModel(file,
                "has no node '" + name.substr(0, kMostOfAName) +
                    (names.empty() ? "', and none with triangles" : "'; those with triangles are " + names));
}

}  // namespace demolish
