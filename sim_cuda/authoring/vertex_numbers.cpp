// SPDX-License-Identifier: Apache-2.0
// Ids by key: keys are dealt into buckets by kind and first id, and the small buckets sorted in parallel.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "sim_cuda/authoring/vertex_keys.h"

namespace demolish {

namespace {

/// Buckets in key order: mesh vertices, mesh edges, triangles, seeds.
class Buckets {
  public:
    explicit Buckets(const KeySpace& space) : first_{0, space.mesh.positions.size(), 0, 0, 0} {
        first_[2] = first_[1] + space.edges.ends.size();
        first_[3] = first_[2] + space.mesh.triangles.size();
        first_[4] = first_[3] + space.seeds.size();
    }
    size_t count() const { return first_[4]; }
    size_t operator()(const VertexKey& key) const { return first_[size_t(key.kind)] + key.ids[0]; }

  private:
    std::array<size_t, 5> first_;
};

}  // namespace

NumberedVertices numberVertices(const KeySpace& space, const std::vector<VertexKey>& keys) {
    const Buckets bucket(space);
    std::vector<uint32_t> start(bucket.count() + 1, 0);
    for (const VertexKey& key : keys) ++start[bucket(key) + 1];
    for (size_t b = 1; b < start.size(); ++b) start[b] += start[b - 1];
    std::vector<uint32_t> entries(keys.size()), next(start.begin(), start.end() - 1);
    for (uint32_t entry = 0; entry < keys.size(); ++entry) entries[next[bucket(keys[entry])]++] = entry;

    std::vector<uint32_t> first_id(bucket.count() + 1, 0);  // counts of unique keys, then their running sum
    const auto inParallel = [&](auto&& visit) {
        tbb::parallel_for(tbb::blocked_range<size_t>(0, bucket.count(), 1024), [&](const auto& range) {
            for (size_t b = range.begin(); b < range.end(); ++b) visit(b);
        });
    };
    inParallel([&](size_t b) {
        const auto begin = entries.begin() + start[b], end = entries.begin() + start[b + 1];
        std::sort(begin, end, [&](uint32_t x, uint32_t y) { return keys[x].ids < keys[y].ids; });
        for (auto entry = begin; entry != end; ++entry)
            first_id[b + 1] += entry == begin || keys[*entry] != keys[*(entry - 1)];
    });
    for (size_t b = 1; b < first_id.size(); ++b) first_id[b] += first_id[b - 1];

    NumberedVertices result;
    result.vertices.resize(first_id.back());
    result.ids.resize(keys.size());
    inParallel([&](size_t b) {
        uint32_t id = first_id[b] - 1;
        for (uint32_t slot = start[b]; slot < start[b + 1]; ++slot) {
            const VertexKey& key = keys[entries[slot]];
            if (slot == start[b] || key != keys[entries[slot - 1]])
                result.vertices[++id] = {key, positionOf(space, key)};
            result.ids[entries[slot]] = id;
        }
    });
    return result;
}

}  // namespace demolish
