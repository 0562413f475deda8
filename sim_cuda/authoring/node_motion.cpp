// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/node_motion.h"

#include <algorithm>

namespace demolish {
namespace {

constexpr double kUsualTicks = 25;  // per second, where a file says none
constexpr double kLongest = 3600;   // s

template <class Key>
void addTimes(const Key* keys, unsigned count, double ticks_per_second, std::vector<double>& times) {
    for (unsigned k = 0; k < count; ++k)
        if (const double time = keys[k].mTime / ticks_per_second; time > 0 && time <= kLongest)
            times.push_back(time);
}

aiVector3D mixed(const aiVector3D& a, const aiVector3D& b, float share) {
    return a + share * (b - a);
}
aiQuaternion mixed(const aiQuaternion& a, const aiQuaternion& b, float share) {
    aiQuaternion between;
    aiQuaternion::Interpolate(between, a, b, share);
    return between.Normalize();
}

/// `usual` where there is no key; before the first and after the last as they are.
template <class Key, class Value>
Value valueAt(const Key* keys, unsigned count, double tick, const Value& usual) {
    if (count == 0) return usual;
    const Key* const end = keys + count;
    const Key* const next =
        std::upper_bound(keys, end, tick, [](double t, const Key& key) { return t < key.mTime; });
    if (next == keys) return keys->mValue;
    if (next == end) return (end - 1)->mValue;
    const Key& before = *(next - 1);
    const double length = next->mTime - before.mTime;
    return mixed(before.mValue, next->mValue,
                 length > 0 ? static_cast<float>((tick - before.mTime) / length) : 0.0f);
}

aiMatrix4x4 localAt(const aiNode& node, const aiNodeAnim& channel, double tick) {
    aiVector3D scale, place;
    aiQuaternion turn;
    node.mTransformation.Decompose(scale, turn, place);
    return {valueAt(channel.mScalingKeys, channel.mNumScalingKeys, tick, scale),
            valueAt(channel.mRotationKeys, channel.mNumRotationKeys, tick, turn),
            valueAt(channel.mPositionKeys, channel.mNumPositionKeys, tick, place)};
}

}  // namespace

NodeMotion::NodeMotion(const aiScene& scene, const aiNode& node) {
    for (const aiNode* at = &node; at != nullptr; at = at->mParent) chain_.push_back({at});
    std::reverse(chain_.begin(), chain_.end());
    for (Link& link : chain_)
        for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
            const aiAnimation& animation = *scene.mAnimations[a];
            for (unsigned c = 0; c < animation.mNumChannels && link.channel == nullptr; ++c) {
                const aiNodeAnim& channel = *animation.mChannels[c];
                if (channel.mNodeName != link.node->mName) continue;
                link.channel = &channel;
                link.ticks_per_second =
                    animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : kUsualTicks;
                addTimes(channel.mPositionKeys, channel.mNumPositionKeys, link.ticks_per_second, times_);
                addTimes(channel.mRotationKeys, channel.mNumRotationKeys, link.ticks_per_second, times_);
                addTimes(channel.mScalingKeys, channel.mNumScalingKeys, link.ticks_per_second, times_);
            }
        }
    std::sort(times_.begin(), times_.end());
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
}

NodeTransform NodeMotion::at(double time) const {
    NodeTransform place;
    for (const Link& link : chain_)
        place = chained(place, link.channel != nullptr
                                   ? localAt(*link.node, *link.channel, time * link.ticks_per_second)
                                   : link.node->mTransformation);
    return place;
}

}  // namespace demolish
