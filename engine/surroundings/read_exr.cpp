// SPDX-License-Identifier: Apache-2.0
// OpenEXR pictures, by its library: the first part of a file, its R, G and B, or its Y.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>

#include "engine/image/png.h"
#include "engine/surroundings/read_picture.h"

namespace demolish::engine {
namespace {

RadiancePicture readFirstPart(const std::filesystem::path& name, Imf::MultiPartInputFile& file) {
    const Imf::Header& header = file.header(0);
    if (header.hasType() && Imf::isDeepData(header.type()))
        throw ImageError(name.string() + " holds deep data; flatten it first.");
    const Imath::Box2i window = header.dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    requirePictureSize(name, width, height);
    const Imf::ChannelList& channels = header.channels();
    const bool is_grey = channels.findChannel("R") == nullptr && channels.findChannel("Y") != nullptr;
    if (!is_grey && (channels.findChannel("R") == nullptr || channels.findChannel("G") == nullptr ||
                     channels.findChannel("B") == nullptr))
        throw ImageError(name.string() + " has no channels R, G and B.");
    if (is_grey && channels.findChannel("RY") != nullptr)
        throw ImageError(name.string() + " is stored as luminance and chroma; save it as RGB.");

    RadiancePicture picture(static_cast<int>(width), static_cast<int>(height));
    Imf::FrameBuffer slices;
    const auto slice = [&](size_t component) {
        char* first = reinterpret_cast<char*>(&picture.texels[0][static_cast<glm::length_t>(component)]);
        return Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(glm::vec3),
                                sizeof(glm::vec3) * static_cast<size_t>(width));
    };
    const char* const names[] = {"R", "G", "B"};
    if (is_grey)
        slices.insert("Y", slice(0));
    else
        for (size_t component = 0; component < 3; ++component)
            slices.insert(names[component], slice(component));
    Imf::InputPart part(file, 0);
    part.setFrameBuffer(slices);
    part.readPixels(window.min.y, window.max.y);
    if (is_grey)
        for (glm::vec3& texel : picture.texels) texel = glm::vec3(texel.x);
    return picture;
}

}  // namespace

RadiancePicture readOpenExr(const std::filesystem::path& name) {
    try {
        Imf::MultiPartInputFile file(name.c_str(), 0);  // without threads of its own
        return readFirstPart(name, file);
    } catch (const ImageError&) {
        throw;
    } catch (const std::exception&) {  // its messages are of several sentences
        throw ImageError(name.string() + " is damaged, or no OpenEXR picture.");
    }
}

}  // namespace demolish::engine
