// SPDX-License-Identifier: Apache-2.0
// The distance grid's own field where the mesh is closed; else winding numbers, by blocks where nothing is
// near.
#include "sim_cuda/authoring/repair/inside_field.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/repair/winding_number.h"

namespace demolish {
namespace {

constexpr int kBlock = 8;              // nodes along each side
constexpr double kBand = 2.5;          // steps from the surface within which every node is asked
constexpr double kStepsOfWinding = 8;  // a winding number off by one counts as a distance of so many steps

struct Block {
    int x0, y0, z0, x1, y1, z1;  // x1 is one past the last
};

Block blockOf(const NodeFrame& frame, int number) {
    const auto blocks = [](int nodes) { return (nodes + kBlock - 1) / kBlock; };
    const int x = number % blocks(frame.nx) * kBlock,
              y = number / blocks(frame.nx) % blocks(frame.ny) * kBlock,
              z = number / blocks(frame.nx) / blocks(frame.ny) * kBlock;
    return {x,
            y,
            z,
            std::min(frame.nx, x + kBlock),
            std::min(frame.ny, y + kBlock),
            std::min(frame.nz, z + kBlock)};
}

template <typename Visit>
void forEachNode(const Block& block, Visit&& visit) {
    for (int z = block.z0; z < block.z1; ++z)
        for (int y = block.y0; y < block.y1; ++y)
            for (int x = block.x0; x < block.x1; ++x) visit(x, y, z);
}

/// 1 or -1 where the corners and the middle of the block agree on being outside or inside, else 0.
int sideOf(const Block& block, const NodeFrame& frame, const WindingNumber& winding) {
    bool maybe_inside = false, maybe_outside = false;
    const auto ask = [&](int x, int y, int z) {
        const double w = winding.at(frame.node(x, y, z));
        maybe_inside = maybe_inside || w > 0.4;
        maybe_outside = maybe_outside || w < 0.6;
    };
    for (int corner = 0; corner < 8; ++corner)
        ask((corner & 1) != 0 ? block.x1 - 1 : block.x0, (corner & 2) != 0 ? block.y1 - 1 : block.y0,
            (corner & 4) != 0 ? block.z1 - 1 : block.z0);
    ask((block.x0 + block.x1 - 1) / 2, (block.y0 + block.y1 - 1) / 2, (block.z0 + block.z1 - 1) / 2);
    return maybe_inside && maybe_outside ? 0 : maybe_inside ? -1 : 1;
}

void fillBlock(const Block& block, const NodeFrame& frame, const MeshQueries& queries,
               const WindingNumber& winding, std::vector<float>& field) {
    constexpr double kHalfDiagonal = 0.87;  // of a block's side
    const double band = kBand * frame.step, side = kBlock * frame.step;
    const Double3 middle =
        (frame.node(block.x0, block.y0, block.z0) + frame.node(block.x1 - 1, block.y1 - 1, block.z1 - 1)) *
        0.5;
    const bool is_far = queries.closestPoint(middle, band + side).distance > band + side * kHalfDiagonal;
    if (const int outside = is_far ? sideOf(block, frame, winding) : 0) {
        forEachNode(block, [&](int x, int y, int z) {
            field[frame.index(x, y, z)] = float(outside * kStepsOfWinding * frame.step);
        });
        return;
    }
    forEachNode(block, [&](int x, int y, int z) {
        const Double3 node = frame.node(x, y, z);
        const double off = winding.at(node) - 0.5, size = kStepsOfWinding * frame.step * std::abs(off),
                     distance = is_far ? size : std::min(size, queries.closestPoint(node, band).distance);
        field[frame.index(x, y, z)] = float(off > 0 ? -distance : distance);
    });
}

std::vector<float> windingField(const TriangleMesh& mesh, const MeshQueries& queries,
                                const NodeFrame& frame) {
    const WindingNumber winding(mesh);
    std::vector<float> field(frame.size());
    const auto blocks = [](int nodes) { return (nodes + kBlock - 1) / kBlock; };
    tbb::parallel_for(0, blocks(frame.nx) * blocks(frame.ny) * blocks(frame.nz),
                      [&](int number) { fillBlock(blockOf(frame, number), frame, queries, winding, field); });
    return field;
}

}  // namespace

NodeFrame frameAbout(const TriangleMesh& mesh, int cells) {
    // Uneven, so that no node lies on the walls of a model drawn on a grid.
    constexpr double kRoom = 2.37;
    const Bounds bounds = boundsOf(mesh.positions);
    NodeFrame frame;
    frame.step = length(bounds.size()) / cells;
    frame.origin = bounds.lower - Double3{kRoom, kRoom, kRoom} * frame.step;
    const auto nodes = [&](double size) { return int(size / frame.step + 2 * kRoom) + 2; };
    frame.nx = nodes(bounds.size().x);
    frame.ny = nodes(bounds.size().y);
    frame.nz = nodes(bounds.size().z);
    return frame;
}

std::vector<float> insideField(const TriangleMesh& mesh, const MeshQueries& queries, const NodeFrame& frame,
                               bool is_closed) {
    std::vector<float> field =
        is_closed ? signedDistances(mesh, queries, frame) : windingField(mesh, queries, frame);
    const auto least = float(1e-3 * frame.step), outside = float(1e-2 * frame.step);
    for (int z = 0; z < frame.nz; ++z)
        for (int y = 0; y < frame.ny; ++y)
            for (int x = 0; x < frame.nx; ++x) {
                float& value = field[frame.index(x, y, z)];
                if (x == 0 || y == 0 || z == 0 || x == frame.nx - 1 || y == frame.ny - 1 || z == frame.nz - 1)
                    value = std::max(value, outside);
                if (std::abs(value) < least) value = value < 0 ? -least : least;
            }
    return field;
}

}  // namespace demolish
