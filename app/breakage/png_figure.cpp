// SPDX-License-Identifier: Apache-2.0
// rsvg-convert as a child process whose picture comes through a pipe.
#include "app/breakage/png_figure.h"

#include <array>
#include <chrono>
#include <string>

#include "app/process/child_process.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

std::string allOf(ChildProcess& child) {
    std::string text;
    std::array<uint8_t, 65536> block{};
    for (;;) {
        const auto size = child.read(block, std::chrono::seconds(1));
        if (size == 0u) return text;
        text.append(reinterpret_cast<const char*>(block.data()), size.value_or(0));
    }
}

}  // namespace

bool drawAsPng(const fs::path& svg) {
    fs::path png = svg;
    png.replace_extension(".png");
    try {
        // A path from the root on, since others may look like an option or a URL.
        ChildProcess convert(ChildPlan{.words = {"rsvg-convert", "--zoom=2", fs::absolute(svg).string()},
                                       .output = ChildStream::kPiped});
        const std::string picture = allOf(convert);
        if (!convert.wait().well())
            throw OutputError("could not write the figure " + png.string() + ": rsvg-convert failed");
        writeTextFile(png, picture);
        return true;
    } catch (const ChildError& error) {
        if (error.is_missing) return false;
        throw OutputError("could not write the figure " + png.string() + ": " + error.what());
    }
}

}  // namespace demolish
