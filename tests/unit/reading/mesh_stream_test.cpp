// SPDX-License-Identifier: Apache-2.0
// The stream of a mesh: the same bits at its other end, and nothing at all from a stream that is not whole.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "app/reading/mesh_stream.h"
#include "app/reading/set_text.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

using Bytes = std::vector<uint8_t>;

constexpr size_t kCountsEnd = 40;  // of the header

Bytes bytesOf(const ModelAnswer& answer) {
    Bytes bytes;
    writeAnswer(answer,
                [&](std::span<const uint8_t> part) { bytes.insert(bytes.end(), part.begin(), part.end()); });
    return bytes;
}

/// `most`: the largest piece that was asked for at once.
ModelAnswer answerIn(const Bytes& bytes, size_t* most = nullptr) {
    std::span<const uint8_t> left = bytes;
    return readAnswer([&](std::span<uint8_t> into) {
        if (most != nullptr) *most = std::max(*most, into.size());
        if (into.size() > left.size()) throw BrokenStream("the end");
        std::copy_n(left.begin(), into.size(), into.begin());
        left = left.subspan(into.size());
    });
}

template <class Array>
void expectSameBits(const Array& a, const Array& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]), 0);
}

TriangleMesh sphere() {
    TriangleMesh mesh = test::makeSphere(1, 5);  // more than one part of the stream
    mesh.name = "sphere";
    return mesh;
}

TEST(MeshStream, KeepsEveryBit) {
    TriangleMesh sent = sphere();
    sent.positions[0].x = -0.0;
    sent.positions[1].y = std::numeric_limits<double>::denorm_min();
    const ModelContents contents{3, 2, 5, true};
    const auto model = std::get<ImportedModel>(answerIn(bytesOf(ImportedModel{sent, contents})));
    EXPECT_EQ(model.contents, contents);
    const TriangleMesh& got = model.mesh;
    EXPECT_EQ(got.name, "sphere");
    expectSameBits(got.positions, sent.positions);
    expectSameBits(got.triangles, sent.triangles);
    expectSameBits(got.corners, sent.corners);
}

ModelLooks someLooks() {
    ModelLooks looks;
    looks.materials.resize(2);
    looks.materials[1].metallic = 0.5f;
    looks.materials[1].base_map = {1, 2, TextureWrap::kMirror, TextureWrap::kClamp};
    looks.images = {{1, 1, {1, 2, 3, 4}}, {300, 301, std::vector<uint8_t>(4 * 300 * 301, 7)}};
    looks.has_colours = true;
    looks.notes = {"one", "another"};
    return looks;
}

ImportedModel lookedCube(const ModelLooks& looks) {
    ImportedModel model{test::makeCube(1)};
    for (auto& corners : model.mesh.corners)
        for (CornerAttributes& corner : corners) corner.material = 1;
    model.looks = std::make_shared<ModelLooks>(looks);
    return model;
}

TEST(MeshStream, KeepsLooks) {
    const ModelLooks sent = someLooks();
    const auto model = std::get<ImportedModel>(answerIn(bytesOf(lookedCube(sent))));
    ASSERT_NE(model.looks, nullptr);
    EXPECT_EQ(model.looks->materials, sent.materials);
    EXPECT_EQ(model.looks->notes, sent.notes);
    EXPECT_TRUE(model.looks->has_colours);
    ASSERT_EQ(model.looks->images.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(model.looks->images[i].width, sent.images[i].width);
        EXPECT_EQ(model.looks->images[i].height, sent.images[i].height);
        EXPECT_EQ(model.looks->images[i].texels, sent.images[i].texels);
    }
    EXPECT_EQ(std::get<ImportedModel>(answerIn(bytesOf(ImportedModel{test::makeCube(1)}))).looks, nullptr);
}

TEST(MeshStream, LooksThatWouldCrashTheirUserAreRefused) {
    const auto expectRefused = [](const std::function<void(ModelLooks&)>& spoil) {
        ModelLooks looks = someLooks();
        spoil(looks);
        EXPECT_THROW(answerIn(bytesOf(lookedCube(looks))), BrokenStream);
    };
    expectRefused([](ModelLooks& looks) { looks.materials[1].base_map.image = 2; });
    expectRefused([](ModelLooks& looks) { looks.materials[0].normal_map = {0, 4}; });
    expectRefused([](ModelLooks& looks) { looks.materials[1].base_map.uv_set = 2; });
    expectRefused([](ModelLooks& looks) { looks.materials[0].emission[1] = std::nanf(""); });
    expectRefused([](ModelLooks& looks) { looks.materials.pop_back(); });  // the cube's own
    expectRefused([](ModelLooks& looks) { looks.images[0].width = 0; });
    expectRefused([](ModelLooks& looks) { looks.images[0].width = kMostImageEdge + 1; });
    expectRefused([](ModelLooks& looks) { looks.images[1].height = 302; });  // fewer texels than it says
    expectRefused(
        [](ModelLooks& looks) { looks.materials[0].base_map.wrap_u = static_cast<TextureWrap>(3); });
}

TEST(MeshStream, WhatStandsInASetKeepsItsNumbersAndIsChecked) {
    ModelSet set;
    set.things = {{"cup \"1\"",
                   {-0.1, 0, 0.3},
                   {1.0 / 3, 2, 3},
                   12,
                   {{0, {1, 2, 3}, {}}, {0.5, {4, 5, 6}, {0.6, 0, 0, 0.8}}}}};
    set.camera = SetCamera{{1, 2, 3},
                           {0, 0, 0},
                           {0, 1, 0},
                           0.7,
                           {{0.1, {1, 2, 4}, {0, 0, 1}, {0, 1, 0}}, {2, {}, {0, 1, 0}, {0.6, 0, 0.8}}}};
    set.sun = SetSun{{0, -1, 0}, {3, 2, 0.1}};
    const auto text = std::get<ModelSetText>(answerIn(bytesOf(ModelSetText{setText(set)}))).text;
    const ModelSet got = setOfText(text);
    ASSERT_EQ(got.things.size(), 1u);
    EXPECT_EQ(got.things[0].node, set.things[0].node);
    EXPECT_EQ(got.things[0].high, set.things[0].high);
    ASSERT_EQ(got.things[0].motion.size(), 2u);
    EXPECT_EQ(got.things[0].motion[1].middle, set.things[0].motion[1].middle);
    EXPECT_EQ(got.things[0].motion[1].turn, set.things[0].motion[1].turn);
    EXPECT_EQ(got.things[0].motion[1].time, 0.5);
    EXPECT_EQ(got.camera.value().eye, set.camera->eye);
    ASSERT_EQ(got.camera->path.size(), 2u);
    EXPECT_EQ(got.camera->path[0].time, 0.1);
    EXPECT_EQ(got.camera->path[1].target, set.camera->path[1].target);
    EXPECT_EQ(got.camera->path[1].up, set.camera->path[1].up);
    EXPECT_EQ(got.sun.value().direction, set.sun->direction);
    EXPECT_EQ(got.sun->colour, set.sun->colour);
    for (const char* bad :
         {"", "-7", "9999999", "1\n0 0 0 1 1 1 12 9 cup\n0\n0\n", "1\n0 0 0 1 1 1 12 3 cup 9999\n0\n0\n",
          "1\n0 0 0 1 1 1 12 3 cup 2\n1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n0\n0\n", "0\n2\n",
          "0\n0\n1\n1 2 nan 1 1 1\n", "0\n0\n1\n1 2\n", "0\n1\n1 2 3 0 0 0 0 1 0 1 9999999\n0\n",
          "0\n1\n1 2 3 0 0 0 0 1 0 1 2\n2 1 1 1 2 2 2 0 1 0\n1 1 1 1 2 2 2 0 1 0\n0\n"})
        EXPECT_THROW(setOfText(bad), BrokenStream) << bad;
}

TEST(MeshStream, ARefusalIsItsSentence) {
    EXPECT_EQ(std::get<ModelRefusal>(answerIn(bytesOf(ModelRefusal{"No."}))).sentence, "No.");
    const auto longest = std::get<ModelRefusal>(answerIn(bytesOf(ModelRefusal{std::string(100000, 'a')})));
    EXPECT_EQ(longest.sentence.size(), kMostText);
}

TEST(MeshStream, EveryCutAndEveryFlippedBitIsFound) {
    const Bytes whole = bytesOf(ImportedModel{test::makeCube(1)});
    for (size_t size = 0; size < whole.size(); ++size)
        EXPECT_THROW(answerIn(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))),
                     BrokenStream);
    for (size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        Bytes flipped = whole;
        flipped[bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
        EXPECT_THROW(answerIn(flipped), BrokenStream) << bit;
    }
}

/// With a count of the header written over.
Bytes withCount(size_t at, uint64_t count) {
    Bytes bytes = bytesOf(ImportedModel{test::makeCube(1)});
    std::memcpy(bytes.data() + at, &count, sizeof count);
    return bytes;
}

TEST(MeshStream, AnnouncedCountsMakeNoRoom) {
    for (const size_t at : {kCountsEnd - 24, kCountsEnd - 16, kCountsEnd - 8})
        for (const uint64_t count : {~uint64_t{0}, uint64_t{1} << 40, kMostTriangles + 1, kMostTriangles}) {
            size_t most = 0;
            EXPECT_THROW(answerIn(withCount(at, count), &most), BrokenStream);
            EXPECT_LE(most, size_t{4} << 20);
        }
}

TEST(MeshStream, MeshesThatWouldCrashTheirUserAreRefused) {
    TriangleMesh mesh = sphere();
    mesh.triangles[7][1] = static_cast<uint32_t>(mesh.positions.size());
    EXPECT_THROW(answerIn(bytesOf(ImportedModel{mesh})), BrokenStream);
    mesh = sphere();
    mesh.positions[3].z = std::nan("");
    EXPECT_THROW(answerIn(bytesOf(ImportedModel{mesh})), BrokenStream);
    mesh = sphere();
    mesh.corners[2][0].uv.y = std::numeric_limits<float>::infinity();
    EXPECT_THROW(answerIn(bytesOf(ImportedModel{mesh})), BrokenStream);
}

}  // namespace
}  // namespace demolish
