#version 450 core
// Sky behind everything; below the horizon the haze that the floor fades into.
#include "common/frame.glsl"
#include "common/sky.glsl"
in vec2 uv;
layout(location = 0) out vec4 colour;

void main() { colour = vec4(skyRadiance(rayThrough(uv)), 0.0); }
