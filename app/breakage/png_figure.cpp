// SPDX-License-Identifier: Apache-2.0
// rsvg-convert as a child process that writes a file of its own, which is then renamed.
#include "app/breakage/png_figure.h"

#include <unistd.h>

#include <string>

#include "app/process/child_process.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
bool drawAsPng(const fs::path& svg) {
    fs::path png = svg;
    png.replace_extension(".png");
    const fs::path unfinished = png.string() + "." + std::to_string(getpid());
    std::error_code failure;
    std::string why;
    try {
        // A path from the root on, since others may look like an option or a URL.
        ChildProcess convert(
            ChildPlan{.words = {"rsvg-convert", "--zoom=2", "--output=" + unfinished.string(),
                                fs::absolute(svg).string()}});
        if (!convert.wait().well())
            why = "rsvg-convert failed; is there room on the disk?";
        else if (fs::rename(unfinished, png, failure); failure)
            why = failure.message();
    } catch (const ChildError& error) {
        if (error.is_missing) return false;
        why = error.what();
    }
    if (why.empty()) return true;
    fs::remove(unfinished, failure);
    throw OutputError("could not write the figure " + png.string() + ": " + why);
}

}  // namespace demolish
