// SPDX-License-Identifier: Apache-2.0
// What changes of the effects from frame to frame: their part of a snapshot.
#pragma once
#include <vector>

#include "sim_cuda/effects/puff.h"

namespace demolish {

/// Empty vectors where there are no effects.
struct EffectState {
    double since_birth = -1;
    uint32_t frames = 0;
    std::vector<uint32_t> births;
    std::vector<Grain> grains;
    std::vector<Puff> puffs;
    std::vector<uint8_t> opened, crumbled;
    std::vector<Vec4<float>> former;

    /// Out: solver/byte_stream.h.
    template <class Out>
    void write(Out& out) const {
        out.writeValue(since_birth);
        out.writeValue(frames);
        out.writeVector(births);
        out.writeVector(grains);
        out.writeVector(puffs);
        out.writeVector(opened);
        out.writeVector(crumbled);
        out.writeVector(former);
    }
    template <class In>
    static EffectState read(In& in) {
        EffectState state;
        state.since_birth = in.template readValue<double>();
        state.frames = in.template readValue<uint32_t>();
        state.births = in.template readVector<uint32_t>();
        state.grains = in.template readVector<Grain>();
        state.puffs = in.template readVector<Puff>();
        state.opened = in.template readVector<uint8_t>();
        state.crumbled = in.template readVector<uint8_t>();
        state.former = in.template readVector<Vec4<float>>();
        return state;
    }
};

}  // namespace demolish
