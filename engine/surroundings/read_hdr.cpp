// SPDX-License-Identifier: Apache-2.0
// Radiance pictures, by the system's stb_image. It takes what a cut file lacks for black: that it asked for
// more than there is, is noticed here.
#include <stb/stb_image.h>

#include <cstdio>
#include <memory>

#include "engine/image/png.h"
#include "engine/surroundings/read_picture.h"

namespace demolish::engine {
namespace {

struct Source {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file;
    bool ran_out = false;

    explicit Source(const std::filesystem::path& name) : file(std::fopen(name.c_str(), "rb"), &std::fclose) {}
};

int readBytes(void* user, char* data, int size) {
    auto& source = *static_cast<Source*>(user);
    const size_t count = std::fread(data, 1, static_cast<size_t>(size), source.file.get());
    source.ran_out = source.ran_out || count == 0;
    return static_cast<int>(count);
}

void skipBytes(void* user, int count) {
    std::fseek(static_cast<Source*>(user)->file.get(), count, SEEK_CUR);
}

int isAtEnd(void* user) {
    return std::feof(static_cast<Source*>(user)->file.get());
}

constexpr stbi_io_callbacks kCallbacks{readBytes, skipBytes, isAtEnd};

}  // namespace

RadiancePicture readRadianceHdr(const std::filesystem::path& file) {
    Source source(file);
    int width = 0, height = 0, channels = 0;
    if (source.file == nullptr || stbi_is_hdr_from_file(source.file.get()) == 0 ||
        stbi_info_from_file(source.file.get(), &width, &height, &channels) == 0)
        throw ImageError(file.string() + " is damaged, or no Radiance picture.");
    requirePictureSize(file, width, height);
    std::rewind(source.file.get());
    const std::unique_ptr<float, void (*)(void*)> values(
        stbi_loadf_from_callbacks(&kCallbacks, &source, &width, &height, &channels, 3), &stbi_image_free);
    if (values == nullptr || source.ran_out)
        throw ImageError(file.string() + " is damaged: it cannot be read to its end.");
    RadiancePicture picture(width, height);
    for (size_t i = 0; i < picture.texels.size(); ++i) {
        const float* texel = values.get() + 3 * i;
        picture.texels[i] = {texel[0], texel[1], texel[2]};
    }
    return picture;
}

}  // namespace demolish::engine
