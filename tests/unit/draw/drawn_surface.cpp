// SPDX-License-Identifier: Apache-2.0
// Plays the parts of solver and renderer round the fracture surface.
#include "tests/unit/draw/drawn_surface.h"

#include <algorithm>

namespace demolish::test {

DrawnSurface::DrawnSurface(const SceneSetup& setup)
    : scene(concatenateGeometry(setup.bodies)), surface(backend, scene) {
    const StreamSizes sizes = streamSizes(setup);
    vertices.resize(sizes.interior_vertices);
    outside.resize(sizes.exterior_vertices);
    chunks.resize(exteriorChunks(outside.size()));
    indices.resize(sizes.interior_indices);
    exterior.resize(sizes.exterior_indices);
    cracks.resize(sizes.crack_edges);
    uint32_t first_cell = 0;
    for (const BodyInstance& instance : setup.bodies) {
        for (const BondGeometry& bond : instance.body->bonds)
            bond_cells.push_back({first_cell + bond.i, first_cell + bond.j});
        volume_ += instance.body->mesh_volume;
        first_cell += static_cast<uint32_t>(instance.body->particles.size());
    }
    broken.resize(bond_cells.size());
    cells_ = first_cell;
    spacing_ = setup.bodies.front().body->spacing;
}

void DrawnSurface::show(const std::vector<uint32_t>& fragment, const std::vector<uint32_t>& cracked) {
    fragments = fragment;
    for (size_t b = 0; b < bond_cells.size(); ++b)
        broken[b] = fragment[bond_cells[b].first] != fragment[bond_cells[b].second];
    for (const uint32_t b : cracked) broken[b] = 1;
    surface.update(fracture());
    writeStreams();
}

Fracture DrawnSurface::fracture() {
    fragment_sizes.assign(size_t{*std::max_element(fragments.begin(), fragments.end())} + 1, 0);
    for (const uint32_t slot : fragments) ++fragment_sizes[slot];
    return {{fragments.data(), fragments.size()},
            {fragment_sizes.data(), fragment_sizes.size()},
            {broken.data(), broken.size()}};
}

void DrawnSurface::writeStreams() {
    RenderStreams streams;
    streams.interior_vertices = {vertices.data(), vertices.size()};
    streams.interior_indices = {indices.data(), indices.size()};
    streams.exterior_vertices = {outside.data(), outside.size()};
    streams.exterior_chunks = {chunks.data(), chunks.size()};
    streams.exterior_indices = {exterior.data(), exterior.size()};
    streams.crack_edges = {cracks.data(), cracks.size()};
    streams.commands = {&commands, 1};
    const Fracture now = fracture();
    surface.write(streams, now.fragment, now.size, fresh);
    openings.assign(broken.size(), 0);
    for (size_t b = 0; b < broken.size(); ++b) openings[b] = broken[b] != 0 ? kOpening : 0;
    surface.writeCracks(streams, now.fragment, {openings.data(), openings.size()});
    fresh = false;
}

std::vector<Soup> DrawnSurface::soups(uint32_t fragment_count) const {
    std::vector<Soup> made(fragment_count);
    const auto add = [&](const std::vector<SurfaceVertex>& from, const std::vector<uint32_t>& triangles,
                         size_t count) {
        for (size_t i = 0; i < count; i += 3) {
            const SurfaceVertex &u = from[triangles[i]], &v = from[triangles[i + 1]],
                                &w = from[triangles[i + 2]];
            made[fragments[u.cell]].push_back({u.position, v.position, w.position});
        }
    };
    add(outside, exterior, commands.exterior.count);
    add(vertices, indices, commands.interior.count);
    return made;
}

SceneSetup sceneOf(std::shared_ptr<const BreakableBody> body) {
    SceneSetup setup;
    setup.bodies.push_back({std::move(body), {}, {}, {}, {}, {}});
    return setup;
}

}  // namespace demolish::test
