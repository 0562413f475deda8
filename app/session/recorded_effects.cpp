// SPDX-License-Identifier: Apache-2.0
// Grains rest soon: most of a frame's slots are those of the frame before.
#include "app/session/recorded_effects.h"

#include <cstring>

namespace demolish {
namespace {

/// Frames from one whole one to the next: so many are gone through at most to show one.
constexpr size_t kWholeEvery = 64;

template <class T>
RecordedSlots<T> wholeSlots(std::span<const T> now) {
    return {static_cast<uint32_t>(now.size()), {}, {now.begin(), now.end()}};
}

template <class T>
RecordedSlots<T> changedSlots(const std::vector<T>& before, std::span<const T> now) {
    RecordedSlots<T> changed;
    changed.used = static_cast<uint32_t>(now.size());
    for (uint32_t k = 0; k < now.size(); ++k) {
        if (k < before.size() && std::memcmp(&before[k], &now[k], sizeof(T)) == 0) continue;
        changed.slot.push_back(k);
        changed.value.push_back(now[k]);
    }
    return changed;
}

}  // namespace

std::shared_ptr<const RecordedEffects> EffectsRecorder::record(std::span<const GrainInstance> grains,
                                                               std::span<const PuffInstance> puffs) {
    auto recorded = std::make_shared<RecordedEffects>();
    recorded->whole_ = frames_ % kWholeEvery == 0;
    recorded->grains_ = recorded->whole_ ? wholeSlots(grains) : changedSlots(grains_, grains);
    recorded->puffs_ = recorded->whole_ ? wholeSlots(puffs) : changedSlots(puffs_, puffs);
    grains_.assign(grains.begin(), grains.end());
    puffs_.assign(puffs.begin(), puffs.end());
    ++frames_;
    return recorded;
}

std::shared_ptr<const RecordedEffects> EffectsRecorder::recordSame() {
    if (frames_ == 0) return nullptr;
    const std::vector<GrainInstance> grains = grains_;
    const std::vector<PuffInstance> puffs = puffs_;
    return record(grains, puffs);
}

}  // namespace demolish
