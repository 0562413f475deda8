// SPDX-License-Identifier: Apache-2.0
// What a solver tells about its state: sums, hash, snapshots, streams for drawing. Part of device_solver.h.
#pragma once
#include "sim_cuda/api/errors.h"
#include "sim_cuda/kernels/measure_energy.h"
#include "sim_cuda/kernels/state_hash.h"
#include "sim_cuda/kernels/sum_frame.h"
#include "sim_cuda/solver/device_solver.h"

namespace demolish {

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::collectFrame(uint32_t substeps) {
    constexpr uint32_t kThreads = Backend::kOnGpu ? 4 : 1;
    const FrameSums sums =
        backend_.reduce(size_t{tables_.counts.total} * kThreads, FrameSums{},
                        SumFrame<kThreads, Real>{data_.arrays(lists_.contacts()), tables_.counts.in_bodies},
                        SumInto<FrameSums>{}, "sum the frame");
    if (setup_.params.ledger) {
        progress_.energy.damping += sums.damping;
        progress_.energy.friction += sums.friction;
        progress_.energy.fracture += sums.fracture;
        backend_.fill(data_.ledger.span(), Vec4<Real>{});
    }
    stats_.fracture_changed = sums.broken != progress_.broken;
    progress_.broken = sums.broken;
    tellFrame(substeps);
    stats_.bonds_broken = sums.broken;
    stats_.bonds_parted = progress_.parted = sums.parted;
    const double kinetic = stats_.energy.kinetic, elastic = stats_.energy.elastic,
                 potential = stats_.energy.potential;
    stats_.energy = progress_.energy;
    stats_.energy.kinetic = kinetic;
    stats_.energy.elastic = elastic;
    stats_.energy.potential = potential;
    stats_.max_stress_ratio = sums.stress;
    if (stats_.fracture_changed) clusters_.update(data_.bonds.row_start.view(), data_.bonds.link.view());
    motion_.advanceAges(clusters_.rows());
    sumFragments();
    if (stats_.fracture_changed) countFragments();
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::tellFrame(uint32_t substeps) {
    stats_.frame = ++progress_.frames;
    stats_.substeps = substeps;
    stats_.time = static_cast<double>(progress_.substeps) * tables_.time_step;
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::bookEnergy(bool on) {
    if (on == setup_.params.ledger) return;
    setup_.params.ledger = on;
    backend_.fill(data_.ledger.span(), Vec4<Real>{});
    recordAhead();
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::countAwake() {
    stats_.bonded_particles = regimes_.bondedParticles();
    stats_.awake_particles = regimes_.bondedParticles() + regimes_.activeParticles();
    stats_.carried_particles = regimes_.carriedParticles();
    stats_.rigid_fragments = regimes_.rigidFragments();
    stats_.sleeping_fragments = regimes_.sleepingFragments();
    stats_.awake_bodies = regimes_.awakeBodies();
}

/// A dry substep gives the velocities after the next kick; then all is put back.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::measure() {
    if (progress_.rebuild != 0) buildLists();
    const BondedWork work = std::exchange(data_.work, BondedWork{});
    const auto constants = std::exchange(data_.constants_in_substeps, {});
    dry_run_.keep(backend_, data_, lists_, regimes_);
    runner_.run(backend_, data_, lists_.contacts(), params_, false, 1);
    dry_run_.putBack(backend_, data_, lists_, regimes_);
    data_.work = work;
    data_.constants_in_substeps = constants;
    const Double3 g = setup_.params.gravity;
    MeasureEnergy<Real> energy{data_.arrays(lists_.contacts()),
                               data_.particles.in(1 - data_.current),
                               params_,
                               {g.x, g.y, g.z},
                               {},
                               {},
                               {}};
    if (regimes_.on()) {
        energy.label = clusters_.fragment();
        energy.regime = regimes_.regime();
        energy.memory = regimes_.bodyMemory();
    }
    const MechanicalSums sums = backend_.reduce(tables_.counts.total, MechanicalSums{}, energy,
                                                SumInto<MechanicalSums>{}, "measure energies");
    stats_.energy.kinetic = sums.kinetic;
    stats_.energy.elastic = sums.elastic;
    stats_.energy.potential = sums.potential;
    stats_.linear_momentum = {sums.linear.x, sums.linear.y, sums.linear.z};
    stats_.angular_momentum = {sums.angular.x, sums.angular.y, sums.angular.z};
}

template <class Backend, class Real>
uint64_t DeviceSolver<Backend, Real>::stateHash() const {
    backend_.fill(hash_sum_.span(), uint64_t{0});
    backend_.forEach(tables_.counts.total,
                     HashParticle<Real>{data_.particles.in(data_.current), data_.bonds.in(),
                                        lists_.contacts().in(), data_.plane_spring.view(),
                                        params_.planes.count, tables_.counts.total, hash_sum_.span()},
                     "hash the state");
    uint64_t hash = 0;
    backend_.download(hash_sum_.view(), &hash);
    return hash;
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::writeBuffers(ByteStream& out) const {
    visitFixedBuffers(data_, lists_, regimes_,
                      [&](auto& buffer) { out.writeVector(backend_.downloaded(buffer.view())); });
    auto& contacts = lists_.contacts();
    out.writeVector(backend_.downloaded(contacts.neighbour.view().part(0, contacts.used)));
    out.writeVector(backend_.downloaded(contacts.spring.view().part(0, contacts.used)));
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::readBuffers(ByteStream& in) {
    const auto readInto = [&](auto span) {
        const auto values = in.readVector<std::remove_const_t<std::remove_reference_t<decltype(span[0])>>>();
        if (values.size() != span.size()) throw std::out_of_range("snapshot of another scene");
        backend_.upload(span, values.data(), values.size());
        backend_.synchronize();
    };
    visitFixedBuffers(data_, lists_, regimes_, [&](auto& buffer) { readInto(buffer.span()); });
    auto& contacts = lists_.contacts();
    readInto(contacts.neighbour.span().part(0, contacts.used));
    readInto(contacts.spring.span().part(0, contacts.used));
}

template <class Backend, class Real>
Snapshot DeviceSolver<Backend, Real>::save() const {
    ByteStream out;
    out.writeValue(tables_.counts);
    out.writeValue(progress_);
    out.writeVector(projectiles_);
    out.writeValue(lists_.contacts().used);
    out.writeValue(lists_.horizon());
    writeBuffers(out);
    out.writeVector(motion_.saveState());
    out.writeValue(surface_of_);
    out.writeVector(surface_.saveState());
    return {out.take()};
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::restore(const Snapshot& snapshot) {
    try {
        ByteStream in(snapshot.bytes);
        const auto counts = in.readValue<ParticleCounts>();
        if (counts.total != tables_.counts.total) throw std::out_of_range("snapshot of another scene");
        progress_ = in.readValue<Progress>();
        regimes_.remember(progress_.regimes);
        projectiles_ = in.readVector<Projectile>();
        const auto used = in.readValue<uint32_t>();
        lists_.adopt(used, in.readValue<double>());
        readBuffers(in);
        motion_.restoreState(in.readVector<std::byte>());
        const auto shown = in.readValue<uint32_t>();
        const auto surface = in.readVector<std::byte>();
        if (!in.atEnd()) throw std::out_of_range("snapshot of another scene");
        restoreSurface(shown, surface);
    } catch (const std::out_of_range& problem) {
        throw UsageError(std::string("The state cannot be restored: ") + problem.what() + ".");
    }
    data_.uploadLaws(backend_, buildLawTables(setup_, tables_, projectiles_));
    backend_.fill(data_.ledger.span(), Vec4<Real>{});  // a run without books leaves it as it was
    stats_.status = StepStatus::kOk;
    stats_.frame = progress_.frames;
    stats_.time = static_cast<double>(progress_.substeps) * tables_.time_step;
    stats_.bonds_broken = progress_.broken;
    stats_.bonds_parted = progress_.parted;
    stats_.energy = progress_.energy;
    progress_.quiet = 0;  // regimes have to be decided once more
    sumFragments();
    countFragments();
}

}  // namespace demolish
