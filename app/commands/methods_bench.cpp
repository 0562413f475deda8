// SPDX-License-Identifier: Apache-2.0
#include "app/commands/methods_bench.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "app/commands/interrupt.h"
#include "sim_cuda/api/errors.h"

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
        const std::vector<uint32_t> map = timed(shot, row);
        requireNoInterrupt();
        shot.fineness.particles = particlesOfABody();
        const std::vector<uint32_t> turned = fromTheSide(shot, row);
        row.moved = mapDistance(map, turned);
        row.turned_pieces = pieceSizes(turned).pieces;
        return row;
    }

    /// For a shot that another device has run: only what it takes here is new.
    MethodRow timesOf(const Shot& shot, MethodRow row) {
        timed(shot, row);
        return row;
    }

  private:
    uint32_t particlesOfABody() const { return static_cast<uint32_t>(cells_.body->particles.size()); }
    BuildOptions optionsFor(bool ledger) const {
        return {.draw_geometry = draws(), .ledger = ledger, .reuse = cells_.body ? &cells_ : nullptr};
    }
    bool draws() const { return plan_.mode != BenchMode::kSimulateOnly; }

    std::vector<uint32_t> timed(Shot shot, MethodRow& row) {
        row.name = methodName(shot.method);
        if (cells_.body) shot.fineness.particles = particlesOfABody();
        spdlog::info("method {}", methodName(shot.method));
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
        row.state_hash = session.solver().stateHash();
        if (draws()) row.outline = outlineOf(session);
        std::vector<uint32_t> map = fragmentMap(session);
        row.sizes = pieceSizes(map);
        return map;
    }

    void tellPlace(Session& session, const BenchStage* stage) {
        place_.particles = session.solver().stats().particles;
        place_.bodies = static_cast<uint32_t>(session.built().setup.bodies.size());
        if (stage != nullptr) place_.tellDrawnBy(stage->info().renderer, size_);
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

void MethodsPlace::tellDrawnBy(const std::string& renderer, PictureSize size) {
    drawn_by = renderer + ", " + std::to_string(size.width) + "x" + std::to_string(size.height);
}

std::vector<Method> methodsToCompare(const std::string& names) {
    if (names == "all") return {std::begin(kPaperOrder), std::end(kPaperOrder)};
    std::vector<Method> named;
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) {
        const auto method = methodOf(name);
        if (!method) throw UsageError("--methods knows no method '" + name + "'");
        named.push_back(*method);
    }
    std::vector<Method> methods;
    for (const Method method : kPaperOrder)
        if (std::find(named.begin(), named.end(), method) != named.end()) methods.push_back(method);
    if (methods.empty()) throw UsageError("--methods names no method");
    return methods;
}

std::vector<MethodRow> compareMethods(const Shot& shot, std::span<const Method> methods,
                                      const BenchPlan& plan, const ShotOptions& options, PictureSize size,
                                      MethodsPlace& place) {
    Comparison comparison(plan, options, size, place);
    std::vector<MethodRow> rows(methods.size());
    const MethodRow* ours = nullptr;
    const auto ask = [&](size_t at) {
        Shot asked = shot;
        asked.method = methods[at];
        const bool on_cores = asked.method == Method::kCores;
        if (on_cores) asked.device = DeviceChoice::kAuto;
        if (!on_cores || ours == nullptr) {
            rows[at] = comparison.rowOf(asked);
        } else {
            rows[at] = *ours;
            if (choosesCuda(shot)) rows[at] = comparison.timesOf(asked, rows[at]);
        }
        rows[at].name = methodName(asked.method);
        if (asked.method == Method::kOurs) ours = &rows[at];
    };
    for (size_t at = 0; at < methods.size(); ++at)
        if (methods[at] != Method::kCores) ask(at);
    for (size_t at = 0; at < methods.size(); ++at)
        if (methods[at] == Method::kCores) ask(at);
    return rows;
}

}  // namespace demolish
