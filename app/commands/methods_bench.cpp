// SPDX-License-Identifier: Apache-2.0
#include "app/commands/methods_bench.h"

#include <spdlog/spdlog.h>

#include <memory>
#include <string>
#include <utility>

#include "app/commands/interrupt.h"

namespace demolish {
namespace {

constexpr Method kPaperOrder[] = {Method::kPatternAtImpact, Method::kHeavy, Method::kPattern, Method::kCores,
                                  Method::kOurs};

void requireNoInterrupt() {
    if (InterruptWatch::asked()) throw Interrupted("interrupted; the comparison needs all methods");
}

/// Mesh and cells, for the next method to take over.
BuiltShot cellsOf(const BuiltShot& built) {
    BuiltShot cells;
    cells.shot = built.shot;
    cells.cells = built.cells;
    cells.body = built.body;
    cells.has_draw_geometry = built.has_draw_geometry;
    return cells;
}

class Comparison {
  public:
    Comparison(const BenchPlan& plan, const ShotOptions& options, PictureSize size, MethodsPlace& place)
        : plan_(plan), options_(options), size_(size), place_(place) {}

    MethodRow rowOf(Shot shot) {
        MethodRow row;
        row.method = shot.method;
        if (cells_.body) shot.fineness.particles = static_cast<uint32_t>(cells_.body->particles.size());
        spdlog::info("method {}", methodName(shot.method));
        const std::vector<uint32_t> map = timed(shot, row);
        requireNoInterrupt();
        const std::vector<uint32_t> turned = fromTheSide(shot, row);
        row.moved = mapDistance(map, turned);
        row.turned_pieces = pieceSizes(turned).pieces;
        return row;
    }

  private:
    BuildOptions optionsFor(bool ledger) const {
        return {.draw_geometry = draws(), .ledger = ledger, .reuse = cells_.body ? &cells_ : nullptr};
    }
    bool draws() const { return plan_.mode != BenchMode::kSimulateOnly; }

    std::vector<uint32_t> timed(const Shot& shot, MethodRow& row) {
        BuiltShot built = buildWithBar(shot, optionsFor(false));
        cells_ = cellsOf(built);
        std::unique_ptr<BenchStage> stage;
        if (draws()) stage = std::make_unique<BenchStage>(choosesCuda(shot), built, options_, size_);
        Session session(std::move(built), {.draw = draws(), .record = false});
        const BenchRun run = runBenchPlan(plan_, session, stage.get());
        requireOk(run.status);
        requireNoInterrupt();
        addTimes(run.samples, shot.phases, row);
        tellPlace(session, stage.get());
        row.device = session.solver().deviceName();
        if (draws()) row.outline = outlineOf(session);
        std::vector<uint32_t> map = fragmentMap(session);
        row.sizes = pieceSizes(map);
        return map;
    }

    void tellPlace(Session& session, const BenchStage* stage) {
        place_.particles = session.solver().stats().particles;
        place_.bodies = static_cast<uint32_t>(session.built().setup.bodies.size());
        if (stage == nullptr) return;
        place_.drawn_by =
            stage->info().renderer + ", " + std::to_string(size_.width) + "x" + std::to_string(size_.height);
    }

    std::vector<uint32_t> fromTheSide(const Shot& shot, MethodRow& row) {
        Session session(buildWithBar(turnedImpact(shot, *cells_.body), optionsFor(true)), {.draw = false});
        ProgressBar bar;
        for (uint64_t frame = 0; frame < plan_.frames; ++frame) {
            requireOk(session.advance(watchFrame(bar, frame, plan_.frames, "hit from the side")));
            requireNoInterrupt();
        }
        session.solver().measure();
        row.closure = session.energy().closure();
        return fragmentMap(session);
    }

    const BenchPlan& plan_;
    const ShotOptions& options_;
    PictureSize size_;
    MethodsPlace& place_;
    BuiltShot cells_;
};

}  // namespace

std::vector<MethodRow> compareMethods(const Shot& shot, const BenchPlan& plan, const ShotOptions& options,
                                      PictureSize size, MethodsPlace& place) {
    const bool on_gpu = choosesCuda(shot);
    Shot first = shot;
    Comparison comparison(plan, options, size, place);
    std::vector<MethodRow> rows;
    size_t cores = 0;
    for (const Method method : kPaperOrder) {
        if (method == Method::kCores) {
            cores = rows.size();
            if (!on_gpu) {
                rows.emplace_back();
                continue;
            }
        }
        first.method = method;
        if (traitsOf(method).on_cpu) first.device = DeviceChoice::kAuto;
        rows.push_back(comparison.rowOf(first));
        first.device = shot.device;
    }
    if (!on_gpu) {
        rows[cores] = rows.back();
        rows[cores].method = Method::kCores;
    }
    return rows;
}

}  // namespace demolish
