// SPDX-License-Identifier: Apache-2.0
// How each fragment moves as a rigid body: the transform it is drawn with, and its velocity by (16)-(18).
//
//   start sums -> fold 1, 8, 64 ... -> transforms;  spins about the centres -> fold -> rigid motions
#pragma once
#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "sim_cuda/kernels/write_fragments.h"
#include "sim_cuda/solver/clustering.h"

namespace demolish {

template <class Backend, class Real>
class FragmentMotion {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// rest_position: per particle in bodies, m, in the frame that orientation 1 belongs to. body_particles:
    /// how many particles each body has, in order. across: fragments may be of several bodies, of which none
    /// is whole by itself.
    FragmentMotion(Backend& backend, const std::vector<Vec4<Real>>& rest_position,
                   const std::vector<uint32_t>& body_particles, bool across);

    /// Once a frame, after clustering.
    void advanceAges(const FragmentRows& rows);
    /// Sums of the present state. Does not wait.
    void gather(const FragmentRows& rows, const StateIn<Real>& state,
                Span<const ParticleConstants<Real>> constants);
    /// After gather(): transforms at the fragments' slots, which must fit. Does not wait.
    void writeTransforms(const FragmentRows& rows, Span<FragmentTransform> transforms);
    /// After gather() with the same state: V and omega of every fragment, at its slot. Does not wait.
    Span<const RigidMotion> fitMotions(const FragmentRows& rows, const StateIn<Real>& state,
                                       Span<const ParticleConstants<Real>> constants);
    /// What the fit was made of, by place in the rows: after gather(), after fitMotions().
    Span<const PoseSums> poses() const { return pose_.view(); }
    Span<const SpinSums> spins() const { return spin_.view(); }
    /// As AdvanceAges leaves them, at the fragments' slots.
    Span<const uint32_t> ages() const { return age_.view(); }
    /// After gather(). Waits.
    FragmentSummary summary(const FragmentRows& rows);

    /// Ages, for snapshots. Wait for the device; std::out_of_range when the bytes are of another scene.
    std::vector<std::byte> saveState();
    void restoreState(const std::vector<std::byte>& state);

  private:
    template <class Terms>
    void fold(const FragmentRows& rows, Buffer<Terms>& terms, const char* name);

    Backend& backend_;
    uint32_t count_, largest_body_;  ///< particles; no fragment is larger
    Buffer<Vec4<Real>> rest_position_;
    Buffer<uint32_t> body_particles_, owner_, former_size_, age_;
    Buffer<PoseSums> pose_;
    Buffer<SpinSums> spin_;       ///< allocated when first wanted
    Buffer<RigidMotion> motion_;  ///< likewise
};

inline std::vector<uint32_t> ownersOf(const std::vector<uint32_t>& body_particles) {
    std::vector<uint32_t> owner;
    for (uint32_t body = 0; body < body_particles.size(); ++body)
        owner.insert(owner.end(), body_particles[body], body);
    return owner;
}

template <class Backend, class Real>
FragmentMotion<Backend, Real>::FragmentMotion(Backend& backend, const std::vector<Vec4<Real>>& rest_position,
                                              const std::vector<uint32_t>& body_particles, bool across)
    : backend_(backend),
      count_(static_cast<uint32_t>(rest_position.size())),
      largest_body_(across ? count_ : *std::max_element(body_particles.begin(), body_particles.end())),
      rest_position_(backend.uploaded(rest_position)),
      body_particles_(
          backend.uploaded(across ? std::vector<uint32_t>(body_particles.size()) : body_particles)),
      owner_(backend.uploaded(ownersOf(body_particles))),
      former_size_(backend.template allocate<uint32_t>(count_)),
      age_(backend.template allocate<uint32_t>(count_)),
      pose_(backend.template allocate<PoseSums>(count_)) {
    backend.synchronize();  // the host copies go out of scope
}

template <class Backend, class Real>
void FragmentMotion<Backend, Real>::advanceAges(const FragmentRows& rows) {
    backend_.forEach(
        count_, AdvanceAges{rows, owner_.view(), body_particles_.view(), former_size_.span(), age_.span()},
        "advance ages");
}

template <class Backend, class Real>
template <class Terms>
void FragmentMotion<Backend, Real>::fold(const FragmentRows& rows, Buffer<Terms>& terms, const char* name) {
    for (uint64_t stride = 1; stride < largest_body_; stride *= kFoldWidth)
        backend_.forEach(count_, FoldFragments<Terms>{rows, terms.span(), static_cast<uint32_t>(stride)},
                         name);
}

template <class Backend, class Real>
void FragmentMotion<Backend, Real>::gather(const FragmentRows& rows, const StateIn<Real>& state,
                                           Span<const ParticleConstants<Real>> constants) {
    backend_.forEach(count_, StartPoseSums<Real>{rows, state, constants, rest_position_.view(), pose_.span()},
                     "start pose sums");
    fold(rows, pose_, "fold pose sums");
}

template <class Backend, class Real>
void FragmentMotion<Backend, Real>::writeTransforms(const FragmentRows& rows,
                                                    Span<FragmentTransform> transforms) {
    backend_.forEach(count_, WriteTransforms{rows, pose_.view(), age_.view(), transforms},
                     "write transforms");
}

template <class Backend, class Real>
Span<const RigidMotion> FragmentMotion<Backend, Real>::fitMotions(
    const FragmentRows& rows, const StateIn<Real>& state, Span<const ParticleConstants<Real>> constants) {
    if (spin_.size() < count_) {
        spin_ = backend_.template allocate<SpinSums>(count_);
        motion_ = backend_.template allocate<RigidMotion>(count_);
    }
    backend_.forEach(count_, StartSpinSums<Real>{rows, state, constants, pose_.view(), spin_.span()},
                     "start spin sums");
    fold(rows, spin_, "fold spin sums");
    backend_.forEach(count_, WriteMotions{rows, pose_.view(), spin_.view(), motion_.span()}, "write motions");
    return motion_.view();
}

template <class Backend, class Real>
FragmentSummary FragmentMotion<Backend, Real>::summary(const FragmentRows& rows) {
    return backend_.reduce(count_, FragmentSummary{}, SummaryOf{rows, pose_.view()}, FoldSummaries{},
                           "fragment summary");
}

template <class Backend, class Real>
std::vector<std::byte> FragmentMotion<Backend, Real>::saveState() {
    std::vector<uint32_t> words = backend_.downloaded(former_size_.view());
    const std::vector<uint32_t> ages = backend_.downloaded(age_.view());
    words.insert(words.end(), ages.begin(), ages.end());
    std::vector<std::byte> state(words.size() * sizeof(uint32_t));
    std::memcpy(state.data(), words.data(), state.size());
    return state;
}

template <class Backend, class Real>
void FragmentMotion<Backend, Real>::restoreState(const std::vector<std::byte>& state) {
    std::vector<uint32_t> words(2 * size_t{count_});
    if (state.size() != words.size() * sizeof(uint32_t)) throw std::out_of_range("ages of another scene");
    std::memcpy(words.data(), state.data(), state.size());
    backend_.upload(former_size_.span(), words.data(), count_);
    backend_.upload(age_.span(), words.data() + count_, count_);
    backend_.synchronize();  // the host copy goes out of scope
}

}  // namespace demolish
