// Three dispatches for each list: a bit a triangle and view; places from the counts of bits; the indices.
// Data centre GPUs draw with few of their multiprocessors and compute with all, so that looking at every
// triangle costs far less than drawing it.
#include "engine/passes/triangle_culler.h"

#include <cmath>

namespace demolish::engine {
namespace {

constexpr GLint kBlockRoom = 0, kSourceCommand = 1, kRounding = 2, kSampleCount = 3, kSamplePosition = 4,
                kShadowTexels = 8;
constexpr auto kViewCount = static_cast<uint32_t>(CulledView::kCount);
constexpr size_t kTrianglesPerBlock = 256, kWordsPerBlock = 8;  // as shaders/common/cull.glsl
constexpr size_t kMostBytes = size_t{1} << 30;                  // of the three copies of a list
/// Enough to fill any GPU; each goes on to further blocks.
constexpr uint32_t kGroups = 2048;

constexpr std::array<StreamId, 2> kIndexStream = {StreamId::kExteriorIndices, StreamId::kInteriorIndices};
constexpr std::array<uint32_t, 2> kCommandOf = {kExteriorCommand, kInteriorCommand};

size_t blocksFor(size_t indices) {
    return (indices / 3 + kTrianglesPerBlock - 1) / kTrianglesPerBlock;
}

size_t copiesBytes(size_t blocks) {
    return kViewCount * blocks * kTrianglesPerBlock * 3 * sizeof(uint32_t);
}

/// Window positions lie on a grid of so many pixels at the least, and rounding to it moves a point by half.
float rasteriserRounding() {
    GLint bits = 4;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return std::exp2(-static_cast<float>(bits));
}

}  // namespace

TriangleCuller::TriangleCuller(const std::filesystem::path& shaders)
    : test_(shaders, {"cull_test.comp"}),
      scan_(shaders, {"cull_scan.comp"}),
      write_(shaders, {"cull_write.comp"}) {
    test_.set(kRounding, rasteriserRounding());
}

bool TriangleCuller::suits(const FractureMesh& mesh) {
    size_t bytes = 0;
    for (const StreamId stream : kIndexStream)
        bytes += copiesBytes(blocksFor(mesh.stream(stream).size() / sizeof(uint32_t)));
    return bytes <= kMostBytes;
}

void TriangleCuller::makeRoom(Culled& culled, size_t indices) const {
    const size_t blocks = blocksFor(indices);
    if (blocks <= culled.block_room) return;
    culled.seen_bits = gl::Buffer::immutable(kViewCount * blocks * kWordsPerBlock * sizeof(uint32_t));
    culled.block_counts = gl::Buffer::immutable(kViewCount * blocks * sizeof(uint32_t));
    culled.indices = gl::Buffer::immutable(copiesBytes(blocks));
    culled.commands = gl::Buffer::immutable(kViewCount * kDrawCommandBytes);
    culled.block_room = static_cast<uint32_t>(blocks);
}

void TriangleCuller::bind(Place list) const {
    const Culled& culled = culled_[list];
    bindStorage(StorageBinding::kSourceIndices, mesh_->stream(kIndexStream[list]));
    bindStorage(StorageBinding::kSeenBits, culled.seen_bits);
    bindStorage(StorageBinding::kBlockCounts, culled.block_counts);
    bindStorage(StorageBinding::kVertices,
                list == kExterior ? mesh_->exteriorVertices() : mesh_->stream(StreamId::kInteriorVertices));
    bindStorage(StorageBinding::kSourceCommands, mesh_->stream(StreamId::kCommands));
}

void TriangleCuller::dispatch(gl::Program& program, uint32_t groups) {
    program.use();
    for (const Place list : {kExterior, kInterior}) {
        const Culled& culled = culled_[list];
        bind(list);
        bindStorage(StorageBinding::kCulled, &program == &scan_ ? culled.commands : culled.indices);
        program.set(kBlockRoom, culled.block_room);
        program.set(kSourceCommand, kCommandOf[list]);
        glDispatchCompute(groups, 1, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

void TriangleCuller::run(const FractureMesh& mesh, const RenderTargets& targets, int shadow_texels) {
    mesh_ = &mesh;
    for (const Place list : {kExterior, kInterior})
        makeRoom(culled_[list], mesh.stream(kIndexStream[list]).size() / sizeof(uint32_t));
    bindStorage(StorageBinding::kParticleFragment, mesh.stream(StreamId::kParticleFragment));
    bindStorage(StorageBinding::kTransforms, mesh.stream(StreamId::kTransforms));
    test_.set(kSampleCount, targets.samples);
    for (int i = 0; i < targets.samples; ++i)
        test_.set(kSamplePosition + i, targets.sample_position[static_cast<size_t>(i)]);
    test_.set(kShadowTexels, static_cast<float>(shadow_texels));
    dispatch(test_, kGroups);
    dispatch(scan_, kViewCount);
    dispatch(write_, kGroups);
}

TriangleList TriangleCuller::listOf(Place list, CulledView view) const {
    return {&culled_[list].indices, &culled_[list].commands, static_cast<uint32_t>(view)};
}

BodyTriangles TriangleCuller::triangles(CulledView view) const {
    return {mesh_, listOf(kExterior, view), listOf(kInterior, view)};
}

}  // namespace demolish::engine
