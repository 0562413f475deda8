// SPDX-License-Identifier: Apache-2.0
// Grit and dust of recorded frames: what has changed since the frame before, and everything now and then.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim_cuda/api/render_streams.h"

namespace demolish {

/// Slots of one kind that a frame has changed; of a whole frame all that are in use.
template <class T>
struct RecordedSlots {
    uint32_t used = 0;
    std::vector<uint32_t> slot;  ///< empty where all are there, in order
    std::vector<T> value;

    size_t bytes() const { return slot.size() * sizeof(uint32_t) + value.size() * sizeof(T); }
    void apply(std::vector<T>& all) const {
        all.resize(used);
        for (size_t k = 0; k < value.size(); ++k) all[slot.empty() ? k : slot[k]] = value[k];
    }
};

class RecordedEffects {
  public:
    /// Needs no frame before it.
    bool isWhole() const { return whole_; }
    /// From what the frame before shows to what this one shows.
    void apply(std::vector<GrainInstance>& grains, std::vector<PuffInstance>& puffs) const {
        grains_.apply(grains);
        puffs_.apply(puffs);
    }
    size_t bytes() const { return sizeof(*this) + grains_.bytes() + puffs_.bytes(); }

  private:
    friend class EffectsRecorder;
    bool whole_ = false;
    RecordedSlots<GrainInstance> grains_;
    RecordedSlots<PuffInstance> puffs_;
};

/// Remembers the frame recorded last.
class EffectsRecorder {
  public:
    void clear() { frames_ = 0; }
    std::shared_ptr<const RecordedEffects> record(std::span<const GrainInstance> grains,
                                                  std::span<const PuffInstance> puffs);
    /// Nothing has changed; null where there was nothing.
    std::shared_ptr<const RecordedEffects> recordSame();

  private:
    size_t frames_ = 0;  ///< since the last whole one
    std::vector<GrainInstance> grains_;
    std::vector<PuffInstance> puffs_;
};

}  // namespace demolish
