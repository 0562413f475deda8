// SPDX-License-Identifier: Apache-2.0
// A scene of assets/scenes made small enough for a test, run without drawing.
#pragma once
#include <string>
#include <vector>

#include "app/session/session.h"

namespace demolish::tests {

/// The scene with `particles` a body on the CPU. Of its bodies only those named stay (all, if none is named),
/// and only the balls that are meant for them.
Shot smallScene(const std::string& name, uint32_t particles, const std::vector<uint32_t>& kept = {});

/// Impacts between two times, s, in their order and with gaps in proportion.
struct ImpactTimes {
    double first = 0.1, last = 0.1;
};
/// Moves the shot's balls so that they hit within `times`; a shot of one ball hits at the first.
void bringForward(Shot& shot, const ImpactTimes& times);

struct SceneRunOptions {
    bool ledger = false;         ///< book damping and friction
    bool in_free_space = false;  ///< no gravity, no floor, no settling
};

class SceneRun {
  public:
    explicit SceneRun(const Shot& shot, const SceneRunOptions& options = {});

    /// Fails the test when a step does.
    void runTo(double time);
    const FrameStats& stats() { return session_.solver().stats(); }
    /// With energies and momenta of this moment.
    const FrameStats& measured();
    /// Since the shot's start.
    EnergyBalance energy();
    const SceneSetup& setup() const { return session_.built().setup; }
    uint64_t stateHash() { return session_.solver().stateHash(); }
    /// m, of all particles of the bodies.
    std::vector<Float3> positions();
    /// The fragment of every particle of the bodies.
    std::vector<uint32_t> fragments();
    /// m/s, of all particles together, with the balls left out; costs one frame.
    double rootMeanSquareSpeed();
    /// Share of the bodies' particles that move faster than `speed`, m/s; costs one frame.
    double movingShare(double speed);

  private:
    std::vector<double> speeds();
    Session session_;
};

struct Standing {
    uint32_t broken = 0;  ///< bonds
    double moved = 0;     ///< m, the farthest that a particle was from its start
    double speed = 0;     ///< m/s, root of the mean square at the end
};
/// `seconds` of the shot with nothing that hits, and without sleeping, which would hide a drift.
Standing stand(Shot shot, double seconds);

/// m, the longest way between two looks at the same particles.
double farthest(const std::vector<Float3>& from, const std::vector<Float3>& to);

}  // namespace demolish::tests
