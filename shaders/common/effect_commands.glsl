// SPDX-License-Identifier: Apache-2.0
// How many slots of grit and dust are in use, from their draw commands.
layout(std430, binding = 13) readonly buffer EffectCommands { uvec4 effect_commands[]; };  // count, instances, ...

uint grainCount() { return effect_commands[0].y; }
uint puffCount() { return effect_commands[1].y; }
