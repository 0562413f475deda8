// SPDX-License-Identifier: Apache-2.0
// Comparison with a stored picture. A failure leaves new, reference and difference x 16 side by side in an
// HTML page.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "tests/render/golden_test.h"

namespace demolish::engine::test {
namespace {

constexpr uintmax_t kLargestGolden = 100'000;  // bytes

}  // namespace

std::filesystem::path goldenFile(const std::string& name) {
    return std::filesystem::path(DEMOLISH_SOURCE_DIR) / "tests/render/golden/llvmpipe" / (name + ".png");
}

namespace {

std::filesystem::path outFolder() {
    const char* folder = std::getenv("DEMOLISH_TEST_OUT");
    return folder != nullptr ? std::filesystem::path(folder) : std::filesystem::path(DEMOLISH_RENDER_OUT);
}

void report(const std::string& name, const Image& picture, const Image& reference, const Comparison& result) {
    const std::filesystem::path out = outFolder();
    std::filesystem::create_directories(out);
    writePng(out / (name + "_new.png"), picture);
    writePng(out / (name + "_reference.png"), reference);
    std::string columns = "<img src=\"" + name + "_new.png\"><img src=\"" + name + "_reference.png\">";
    if (result.same_size) {
        writePng(out / (name + "_difference.png"), differencePicture(picture, reference));
        columns += "<img src=\"" + name + "_difference.png\">";
    }
    std::ofstream(out / (name + ".html"))
        << "<!doctype html><title>" << name << "</title><h1>" << name << "</h1><p>wrong pixels "
        << 100.0 * result.wrong_fraction << " %, SSIM " << result.ssim << ", largest difference "
        << result.largest_difference << "</p><p>new, reference, difference x 16</p>" << columns << '\n';
}

}  // namespace

void expectLooksAsStored(const std::string& name, const Image& picture) {
    if (update_goldens) {
        writePng(goldenFile(name), picture, {.compression = 9});
        ASSERT_LT(std::filesystem::file_size(goldenFile(name)), kLargestGolden);
        return;
    }
    const Image reference = readPng(goldenFile(name));
    const Comparison result = compare(picture, reference);
    if (!result.passed) report(name, picture, reference, result);
    EXPECT_TRUE(result.passed) << "wrong pixels " << 100.0 * result.wrong_fraction << " %, SSIM "
                               << result.ssim << "; see " << outFolder() / (name + ".html")
                               << "; accept with --update-goldens if the new picture is right";
}

}  // namespace demolish::engine::test
