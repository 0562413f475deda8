// SPDX-License-Identifier: Apache-2.0
// Only blocks of which a chunk was written are copied.
#include "app/session/recorded_outside.h"

#include <algorithm>
#include <span>

#include "app/bridge/draw_list_use.h"
#include "engine/render/fracture_mesh.h"

namespace demolish {
using engine::StreamId;

RecordedOutside::RecordedOutside(const RecordedOutside* before, const ReadStream& read, size_t vertices) {
    if (vertices == 0) return;
    blocks_.resize((vertices + kBlock - 1) / kBlock);
    std::vector<uint32_t> chunks(exteriorChunks(vertices), 1);
    if (before != nullptr) {
        blocks_ = before->blocks_;
        const auto flags = read(StreamId::kExteriorChunks, 0, chunks.size() * sizeof(uint32_t));
        std::copy_n(reinterpret_cast<const uint32_t*>(flags.data()), chunks.size(), chunks.begin());
    }
    const WrittenVertices written = writtenVertices(chunks, vertices);
    if (written.count == 0) return;
    const size_t first = written.first / kBlock, end = (written.first + written.count + kBlock - 1) / kBlock;
    const size_t begin = first * kBlock, count = std::min(end * kBlock, vertices) - begin;
    const auto bytes =
        read(StreamId::kExteriorVertices, begin * sizeof(SurfaceVertex), count * sizeof(SurfaceVertex));
    const std::span all(reinterpret_cast<const SurfaceVertex*>(bytes.data()), count);
    for (size_t block = first; block < end; ++block) {
        const auto own = std::span(chunks).subspan(block * kChunks);
        const auto used = own.first(std::min(kChunks, own.size()));
        if (std::find_if(used.begin(), used.end(), [](uint32_t flag) { return flag != 0; }) == used.end())
            continue;
        const auto values = all.subspan((block - first) * kBlock);
        const auto copied = values.first(std::min(kBlock, values.size()));
        blocks_[block] = std::make_shared<const RecordedArray<SurfaceVertex>>(copied);
        own_bytes_ += copied.size_bytes();
    }
}

void RecordedOutside::upload(engine::FractureMesh& mesh) const {
    engine::gl::Buffer& stream = mesh.stream(StreamId::kExteriorVertices);
    for (size_t block = 0; block < blocks_.size(); ++block)
        stream.upload(std::as_bytes(blocks_[block]->span()), block * kBlock * sizeof(SurfaceVertex));
}

}  // namespace demolish
