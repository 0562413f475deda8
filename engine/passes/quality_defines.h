// What a render quality means in numbers and in shader text.
#pragma once
#include <string>

#include "engine/render/renderer.h"

namespace demolish::engine {

inline int shadowMapSize(RenderQuality quality) {
    return quality == RenderQuality::kFull ? 2048 : 1024;
}

inline std::string qualityDefines(RenderQuality quality) {
    return quality == RenderQuality::kFull ? "" : "#define SHADOW_DRAFT\n";
}

}  // namespace demolish::engine
