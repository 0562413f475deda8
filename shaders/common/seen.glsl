// SPDX-License-Identifier: Apache-2.0
// What a ray shows that meets nothing, or a floor that only takes shadows: premultiplied light and alpha.
#ifdef TRANSPARENT
vec4 nothingSeen(vec3 ray) { return vec4(0.0); }
vec4 shadowOver(vec3 ray, vec3 left) { return vec4(vec3(0.0), max(1.0 - dot(left, vec3(0.2126, 0.7152, 0.0722)), 0.0)); }
#else
vec4 nothingSeen(vec3 ray) { return vec4(skyRadiance(normalize(ray)), 1.0); }
vec4 shadowOver(vec3 ray, vec3 left) { return vec4(left * skyRadiance(normalize(ray)), 1.0); }
#endif
