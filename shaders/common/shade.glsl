// Light on one surface point. Alpha carries the share of ambient light, which ambient occlusion darkens after the draw.
#include "common/sky.glsl"
#include "common/brdf.glsl"
#include "common/shadow.glsl"

struct Surface {
    vec3 position;          // world, m
    vec3 geometric_normal;  // unit
    vec3 normal;            // unit, bent by noise
    vec3 albedo;
    float roughness;
    float metalness;
};

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

vec4 shade(Surface s, vec2 pixel) {
    vec3 to_eye = normalize(frame.eye.xyz - s.position);
    float n_dot_v = max(dot(s.normal, to_eye), 0.02);
    vec3 f0 = mix(vec3(0.04), s.albedo, s.metalness);
    vec3 diffuse = s.albedo * (1.0 - s.metalness);

    vec3 direct = vec3(0.0);
    float n_dot_l = dot(s.normal, frame.to_sun.xyz);
    if (n_dot_l > 0.0) {
        float visible = sunVisibility(s.position, s.geometric_normal, pixel);
        vec3 half_way = normalize(to_eye + frame.to_sun.xyz);
        float n_dot_h = max(dot(s.normal, half_way), 0.0);
        vec3 f = fresnel(f0, max(dot(to_eye, half_way), 0.0));
        vec3 mirror = f * ggxSpecular(n_dot_h, n_dot_v, n_dot_l, max(s.roughness, 0.06));
        direct = ((1.0 - f) * diffuse / 3.14159265 + mirror) * n_dot_l * visible * frame.sun_colour.rgb * 3.14159265;
    }
    vec3 share = environmentShare(f0, s.roughness, n_dot_v);
    vec3 mirrored = reflectedRadiance(reflect(-to_eye, s.normal), s.roughness);
    vec3 ambient = (1.0 - share) * diffuse * ambientRadiance(s.normal) + share * mirrored;
    vec3 colour = direct + ambient;
    return vec4(colour, luminance(ambient) / max(luminance(colour), 1e-4));
}
