// SPDX-License-Identifier: Apache-2.0
// Looks between the corners of a drawn triangle.
in vec4 look_uv;
in vec4 look_colour;
flat in uint look_material;

Looked drawnLook() { return Looked(look_uv, look_colour, look_material); }

Laid drawnLaid(vec3 position) { return Laid(dFdx(look_uv), dFdy(look_uv), dFdx(position), dFdy(position)); }
