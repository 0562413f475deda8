// SPDX-License-Identifier: Apache-2.0
// One shot being simulated: steps it, brings its frames to the renderer's buffers, records them, rebuilds it
// on a worker.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/built_shot.h"
#include "app/session/commands.h"
#include "app/session/debounce.h"
#include "app/session/energy_balance.h"
#include "app/session/frame_output.h"
#include "app/session/rebuild_worker.h"
#include "app/session/recording.h"

namespace demolish {

struct SessionOptions {
    bool draw = true;                       ///< false: no GL at all
    bool record = false;                    ///< keep frames for the timeline
    size_t memory_limit = size_t{1} << 30;  ///< bytes of recording
};

/// Everything that a panel or report shows, as values.
struct SessionStatus {
    FrameStats stats;  ///< of the frame on screen
    SofteningReport softening;
    std::string device, transfer, transfer_note;
    bool on_gpu = false;
    bool playing = false, replaying = false;
    std::optional<double> frame_share;  ///< of a frame under way, what is simulated
    size_t cursor = 0, newest = 0;      ///< frame on screen, and the solver's, which follows a full recording
    size_t recorded_frames = 0, recorded_bytes = 0, memory_limit = 0;
    uint32_t substeps_per_frame = 0;
    size_t bodies = 1;
    double particle_size = 0;      ///< m, h
    double body_volume = 0;        ///< m^3
    double body_size = 0;          ///< m, what a height scales of the body that the shot is about
    double full_colour_speed = 0;  ///< m/s, at the end of the speed colours
    double build_seconds = 0;
    std::string size_remark;              ///< as sizeRemark(), for the window
    std::string repair;                   ///< what was done to close the model, or ""
    const ModelLooks* looks = nullptr;    ///< of the model file, until the next rebuild; null: none
    bool measuring = false;               ///< energies, after every simulated frame
    std::optional<EnergyBalance> energy;  ///< while measuring; none for a replayed frame
    bool waiting = false;                 ///< a change rests before its rebuild starts
    bool rebuilding = false;
    RebuildWorker::Progress rebuild;
    std::string message;  ///< last thing that went wrong, or ""
};

/// s that a window may wait for a frame before it looks at what its user does.
inline constexpr double kLongestTurn = 0.1;

class Session {
  public:
    /// With options.draw the GL context must be current, here and in every other call. Fires the shot's
    /// balls.
    Session(BuiltShot built, const SessionOptions& options);

    /// One simulated frame, brought to the buffers. A status other than kOk leaves the picture as it was, and
    /// so does a frame that `watch` stops: the next call goes on with it.
    StepStatus advance(const FrameWatch& watch = {});
    /// The share of it that is simulated; none between two frames.
    std::optional<double> frameUnderWay() const { return frame_share_; }
    bool playing() const { return playing_ || stepping_; }

    /// Obeys; `now` in s on any steady clock.
    void apply(const command::Any& command, double now);
    /// Starts and takes over rebuilds; then, while playing, one frame: replayed up to the end of the
    /// recording, simulated from there. `may_step` false: no frame is due yet. A frame that takes longer than
    /// kLongestTurn is spread over several calls; paused, it waits, and what needs the solver gives it up.
    void update(double now, bool may_step = true);

    const Shot& shot() const { return wanted_; }  ///< as chosen, perhaps not yet built
    const BuiltShot& built() const { return built_; }
    /// As of the last whole frame: one that is under way is given up.
    Solver& solver();
    const engine::FractureMesh* mesh() const { return output_ ? &output_->mesh() : nullptr; }
    engine::FractureMesh* mesh() { return output_ ? &output_->mesh() : nullptr; }
    const std::vector<engine::SphereDraw>& spheres() const { return spheres_; }
    const char* transfer() const;
    SessionStatus status() const;
    /// Since the shot's start, or since it was asked for in a shot that is run without ledger; as of the last
    /// Solver::measure().
    EnergyBalance energy() const { return {start_energy_, built_.solver->stats().energy, books_since_}; }
    /// ms of simulating the last frame, all calls of advance() together.
    double lastSimMs() const { return last_sim_ms_; }
    /// ms to write the last simulated frame and bring it to the renderer's buffers; 0 when none was.
    double lastTransferMs() const { return last_transfer_ms_; }

    /// Which channel the particle view is coloured by; acts at once, on recorded frames too.
    void setColour(ParticleColour colour);

  private:
    struct Obey;
    void restart();
    void openBooks();
    void followEffects();
    void restartIfNotHit();
    void wantWhatIsBuilt();
    void fire(const Projectile& ball);
    Shot shotOfBalls() const;
    void startDueBalls();
    void fireByHand();
    void goOn();
    void bringFrame(bool fresh);
    void show(size_t frame);
    void change(const Shot& shot, double now);
    void takeRebuild();
    void adopt(BuiltShot built);
    bool atEnd() const { return cursor_ == newest_; }

    SessionOptions options_;
    BuiltShot built_;
    Shot wanted_;
    Shot live_;  ///< what was last wanted of the scene and model on screen
    std::unique_ptr<FrameOutput> output_;
    std::vector<engine::SphereDraw> spheres_;
    Recording recording_;
    RebuildWorker worker_;
    Debounce<Shot> debounce_{0.25};
    ParticleColour colour_ = ParticleColour::kFragment;
    FrameStats shown_;
    EnergyLedger start_energy_;
    double books_since_ = 0;  ///< s
    std::string message_;
    uint32_t projectiles_ = 0;
    std::vector<bool> balls_started_;  ///< of ballsOf(shotOfBalls()), those that need not start any more
    size_t fired_by_hand_ = 0;
    size_t cursor_ = 0;  ///< frame on screen: a recorded one, or newest_
    size_t newest_ =
        0;  ///< the solver's frame: the last recorded one, or one more where that is not recorded
    double last_sim_ms_ = 0, last_transfer_ms_ = 0;
    std::optional<double> frame_share_;  ///< of a frame under way
    double under_way_ms_ = 0;            ///< that it has taken so far
    bool playing_ = false;
    bool stepping_ = false;  ///< one frame, and no more
    bool measuring_ = false;
    EffectsSettings effects_;  ///< as the solver has been told
};

}  // namespace demolish
