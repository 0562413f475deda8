// SPDX-License-Identifier: Apache-2.0
// Counting pieces in an exported frame.
#include "tests/physics/models/pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tests/physics/solver/exported_frame.h"

namespace demolish::tests {

PieceCounter::PieceCounter(const SceneSetup& setup) {
    for (const Particle& p : setup.bodies[0].body->particles)
        mass_.push_back(p.volume * setup.bodies[0].material.density);
    const size_t streamed = streamSizes(setup).particles;
    fragment_.resize(streamed);
    shown_.resize(streamed);
}

Pieces PieceCounter::count(Solver& solver, double seconds) {
    before_ = shown_;
    ExportedFrame frame = exportedFrame(solver, shown_.size());
    shown_ = std::move(frame.particles);
    fragment_ = std::move(frame.fragments);
    struct Piece {
        double mass = 0, fastest = 0;
        uint32_t particles = 0;
    };
    std::map<uint32_t, Piece> pieces;
    double whole = 0;
    for (size_t i = 0; i < mass_.size(); ++i) {
        Piece& piece = pieces[fragment_[i]];
        piece.mass += mass_[i];
        whole += mass_[i];
        ++piece.particles;
        const Float3 a = before_[i].position, b = shown_[i].position;
        if (seconds > 0)
            piece.fastest = std::max(piece.fastest, std::hypot(b.x - a.x, b.y - a.y, b.z - a.z) / seconds);
    }
    Pieces result;
    result.largest = 0;
    for (const auto& [slot, piece] : pieces) {
        result.largest = std::max(result.largest, piece.mass / whole);
        result.big += piece.mass >= 0.01 * whole;
        result.solid += piece.particles >= 3;
        if (piece.particles < 3) result.dust += piece.mass / whole;
        result.moving += piece.fastest > 0.02;
    }
    return result;
}

}  // namespace demolish::tests
