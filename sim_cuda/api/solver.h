// SPDX-License-Identifier: Apache-2.0
// A scene being simulated, on the CPU or the GPU. One text serves both: they give the same bits.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim_cuda/api/anchors.h"
#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/api/mortar.h"
#include "sim_cuda/api/params.h"
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/api/stats.h"

namespace demolish {

/// One body in the scene. Particles of all bodies stand one after the other, in this order.
struct BodyInstance {
    std::shared_ptr<const BreakableBody> body;
    Material material;
    Double3 position;  ///< m, of the body frame's origin
    Quaternion rotation;
    Double3 velocity;          ///< m/s, of the whole body at the start (a drop)
    Double3 angular_velocity;  ///< rad/s
    /// Lowest threshold of this body, v_th / v_c (models.md E.2): pieces that meet at less than half of it go
    /// on as rigid bodies. The default suits a slender body.
    double threshold_share = 0.3;
    bool in_mortar = true;  ///< false: it only touches others where these are joined
};

struct SceneSetup {
    std::vector<BodyInstance> bodies;  ///< at least one
    std::vector<Projectile> projectiles;
    SolverParams params;
    std::vector<Anchor> anchors;
    std::optional<Mortar> mortar;  ///< none: bodies only touch
};

/// What a progress bar shows; return false to cancel (then Cancelled is thrown).
using ProgressCallback = std::function<bool(double fraction, const char* stage)>;

/// Asked between the stretches of a frame with the share of it that is simulated, 0..1; false: stop there. A
/// stretch is a few dozen substeps.
using FrameWatch = std::function<bool(double share)>;

/// What the softening rule gave (models.md E.1-E.2); shown in panel and report.
struct SofteningReport {
    double bond_modulus = 0;       ///< Pa, E_b
    double effective_modulus = 0;  ///< Pa, E_eff (E4)
    double wave_speed = 0;         ///< m/s, c_eff
    double strength = 0;           ///< Pa, sigma_c
    double strain_at_failure = 0;  ///< eps_c = sigma_c / E_eff; above 0.03 it looks like rubber
    double highest_frequency = 0;  ///< rad/s, omega_max
};

/// Everything that changes while stepping; opaque, restorable on the same setup.
struct Snapshot {
    std::vector<std::byte> bytes;
};

/// Upper bounds of the streams' sizes for a setup, so that the renderer can allocate once.
struct StreamSizes {
    size_t particles = 0, interior_vertices = 0, interior_indices = 0, exterior_vertices = 0,
           exterior_indices = 0, crack_edges = 0;
    size_t grains = 0, puffs = 0;
};
StreamSizes streamSizes(const SceneSetup& setup);

class Solver {
  public:
    virtual ~Solver() = default;

    /// Advances one frame of params.frame_time * time_scale (slow motion: 0 < time_scale <= 1). On a bad
    /// status nothing has changed but the status; the caller may restore() and change a knob.
    /// Stopped by `watch` the frame stays unfinished, and the next call goes on with it, to the same bits
    /// (its own time_scale holds). Until it is whole or given up, stats() are those of the frame before, and
    /// of the other calls only restore() and advanceSubsteps(), which give it up, are allowed.
    virtual StepStatus advanceFrame(double time_scale = 1.0, const FrameWatch& watch = {}) = 0;
    virtual bool frameUnfinished() const = 0;
    /// Back to the last whole frame; nothing happens without an unfinished one.
    virtual void giveUpFrame() = 0;
    /// Exactly n substeps; for tests and benchmarks.
    virtual StepStatus advanceSubsteps(uint32_t n) = 0;

    /// A new projectile from now on; at most kMaxProjectiles in a run. Throws UsageError beyond that. One
    /// that would start inside something starts farther back on its way, clear of it: m that it was moved.
    virtual double fire(const Projectile& projectile) = 0;

    /// Writes the frame into the caller's memory: device memory for a CUDA solver (mapped GL buffers), host
    /// memory for the CPU solver. Draw lists and vertices are written only if fracture changed since the last
    /// export into streams with `streams_fresh` false.
    virtual void exportFrame(const RenderStreams& streams, bool streams_fresh = false) = 0;

    /// streamSizes() of the set-up that it was made from.
    virtual StreamSizes exportSizes() const = 0;

    virtual const FrameStats& stats() const = 0;
    /// Energies and momenta of this moment, summed in double; costs a pass over the particles and bonds.
    virtual void measure() = 0;
    /// Books damping and friction work and fracture from now on, or no longer; SolverParams::ledger says so
    /// for the start. The state stays the same to the last bit, and a substep that books nothing is cheaper.
    virtual void bookEnergy(bool on) = 0;
    virtual bool booksEnergy() const = 0;
    /// From now on; how many grains and puffs there is room for stays as it was in the set-up. Off: those
    /// that fly are gone. The bodies move the same, to the last bit.
    virtual void setEffects(const EffectsSettings& settings) = 0;
    /// 64-bit hash of what the effects show: equal for any thread count and device; 0 while there are none.
    virtual uint64_t effectsHash() const = 0;
    /// 64-bit hash of state, bond and history bits: equal for any thread count, launch shape and device.
    virtual uint64_t stateHash() const = 0;

    virtual Snapshot save() const = 0;
    virtual void restore(const Snapshot& snapshot) = 0;

    virtual const SofteningReport& softening() const = 0;
    virtual std::string deviceName() const = 0;
    virtual bool onGpu() const = 0;
    /// Waits until everything asked for has happened (benchmarks).
    virtual void synchronize() = 0;
    /// The cudaStream_t on which the solver works; null on the CPU. Who maps or copies what a frame is
    /// exported to does so on it, so that nothing needs the legacy stream.
    virtual void* workStream() const = 0;
};

/// Substeps that a frame of softened bodies takes, at this slow motion.
uint32_t substepsOfFrame(const SolverParams& params, double time_scale = 1);

/// What exporting a frame writes into exterior_indices where particles are in these fragments (one slot a
/// particle of the bodies).
std::vector<uint32_t> drawnExterior(const SceneSetup& setup, std::span<const uint32_t> particle_fragment);

/// What the renderer uploads once: exterior, exterior_indices and crack_edges of all bodies, one after the
/// other, with cells, vertices and bonds numbered through the scene as in the streams; the other members are
/// empty.
FractureGeometry sceneExterior(const SceneSetup& setup);

/// Throws UsageError on values out of range, InputFileError on a body that starts inside a collider. Uses all
/// cores that oneTBB is allowed to use.
std::unique_ptr<Solver> makeCpuSolver(const SceneSetup& setup, const ProgressCallback& progress = {});
/// Throws DeviceError when there is no usable GPU, or when the program was built without CUDA.
std::unique_ptr<Solver> makeCudaSolver(const SceneSetup& setup, const ProgressCallback& progress = {});

struct CudaDevice {
    bool built_with_cuda = false;
    bool usable = false;
    int ordinal = 0, count = 0;  ///< the one in use, and how many this process sees
    std::string name;            ///< "NVIDIA H200"
    std::string problem;         ///< why it is not usable, one clause
    int driver_version = 0;
};
/// Never throws; on a machine without a GPU says so.
CudaDevice findCudaDevice();

}  // namespace demolish
