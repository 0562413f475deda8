// SPDX-License-Identifier: Apache-2.0
// libpng behind two functions. Its errors come back by longjmp, so everything with a destructor lives outside
// the jump.
#include "engine/image/png.h"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "engine/image/unfinished_file.h"

namespace demolish::engine {
namespace {

/// Opaque rows lose their fourth byte.
std::vector<uint8_t> packedRows(const Image& image, bool alpha) {
    if (alpha) return image.pixels;
    std::vector<uint8_t> rgb(image.pixels.size() / 4 * 3);
    for (size_t i = 0, pixels = image.pixels.size() / 4; i < pixels; ++i) {
        for (size_t c = 0; c < 3; ++c) rgb[3 * i + c] = image.pixels[4 * i + c];
    }
    return rgb;
}

// libpng would print to stderr by itself; the caller of writePng is told by an exception instead.
void jumpBack(png_structp png, png_const_charp) {
    png_longjmp(png, 1);
}
void ignoreWarning(png_structp, png_const_charp) {}

/// sRGB twice: cICP, which newer programs read first, is unknown to libpng 1.6.
void sayColourSpace(png_structp png, png_infop info) {
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    constexpr png_byte kBt709Primaries = 1, kSrgbCurve = 13, kRgb = 0, kFullRange = 1;
    png_byte values[] = {kBt709Primaries, kSrgbCurve, kRgb, kFullRange};
    png_unknown_chunk chunk{{'c', 'I', 'C', 'P', 0}, values, sizeof values, PNG_HAVE_IHDR};
    constexpr png_byte kName[] = {'c', 'I', 'C', 'P', 0};
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, kName, 1);
    png_set_unknown_chunks(png, info, &chunk, 1);
}

void sayNote(png_structp png, png_infop info, const std::string& note) {
    if (note.empty()) return;
    char key[] = "Description";
    std::string words = note;
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key;
    text.text = words.data();
    text.text_length = words.size();
    png_set_text(png, info, &text, 1);
}

/// False on any libpng or disk error.
bool encode(std::FILE* file, const Image& image, const uint8_t* rows, const PngOptions& options) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jumpBack, ignoreWarning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_init_io(png, file);
    png_set_compression_level(png, options.compression);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 options.alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    sayColourSpace(png, info);
    sayNote(png, info, options.note);
    png_write_info(png, info);
    const size_t row = static_cast<size_t>(image.width) * (options.alpha ? 4 : 3);
    for (int y = 0; y < image.height; ++y) png_write_row(png, rows + row * y);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return true;
}

[[noreturn]] void failWriting(const std::filesystem::path& file, const std::string& why) {
    throw ImageError("Cannot write " + file.string() + ": " + why + ".");
}

}  // namespace

void writePng(const std::filesystem::path& file, const Image& image, const PngOptions& options) {
    if (image.width <= 0 || image.height <= 0)
        throw ImageError("An empty picture cannot be written to " + file.string() + ".");
    try {
        UnfinishedFile unfinished(file.has_parent_path() ? file.parent_path() : ".");
        const std::vector<uint8_t> rows = packedRows(image, options.alpha);
        errno = 0;
        if (!encode(unfinished.stream(), image, rows.data(), options) ||
            std::fflush(unfinished.stream()) != 0)
            failWriting(file, std::string(std::strerror(errno != 0 ? errno : EIO)) + "; is the disk full?");
        unfinished.close();
        unfinished.moveTo(file);
    } catch (const std::system_error& error) {
        failWriting(file, error.code().message());
    }
}

Image readPng(const std::filesystem::path& file) {
    png_image reader{};
    reader.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&reader, file.c_str()) == 0) {
        throw ImageError("Cannot read " + file.string() + ": " + reader.message + ".");
    }
    reader.format = PNG_FORMAT_RGBA;
    Image image;
    image.width = static_cast<int>(reader.width);
    image.height = static_cast<int>(reader.height);
    image.pixels.resize(PNG_IMAGE_SIZE(reader));
    if (png_image_finish_read(&reader, nullptr, image.pixels.data(), 0, nullptr) == 0) {
        throw ImageError("Cannot read " + file.string() + ": " + reader.message + ".");
    }
    return image;
}

}  // namespace demolish::engine
