// SPDX-License-Identifier: Apache-2.0
// The sky: its radiance in a direction, and the light it sends onto a surface together with the floor.
vec3 skyGradient(vec3 direction) {
    float height = max(direction.y, 0.0);
    return mix(frame.sky_horizon.rgb, frame.sky_zenith.rgb, 1.0 - exp(-4.5 * height));
}

// Round the sun: the 6th and the 60th power of the cosine, by products.
vec3 sunGlow(vec3 direction) {
    float c = clamp(dot(direction, frame.to_sun.xyz), 0.0, 1.0);
    float c2 = c * c, c4 = c2 * c2, c6 = c4 * c2, c12 = c6 * c6, c24 = c12 * c12;
    return (0.056 * c6 + 0.1225 * c24 * c24 * c12) * frame.sun_colour.rgb;
}

vec3 skyRadiance(vec3 direction) { return skyGradient(direction) + sunGlow(direction); }

// Light of the sunlit floor seen from below, as a diffuse reflector.
vec3 floorBounce() {
    vec3 received = frame.sun_colour.rgb * max(frame.to_sun.y, 0.0) + 0.8 * frame.sky_horizon.rgb;
    return mix(frame.sky_horizon.rgb * 0.5, frame.floor_colour.rgb * received, frame.floor_colour.w) * 0.6;
}

// Mean radiance over the hemisphere about `normal` (irradiance / pi): zenith, horizon and floor by their solid angles.
vec3 ambientRadiance(vec3 normal) {
    vec3 up = mix(frame.sky_horizon.rgb, frame.sky_zenith.rgb, 0.62);
    vec3 side = 0.5 * (frame.sky_horizon.rgb + floorBounce());
    float y = normal.y;
    vec3 ambient = y > 0.0 ? mix(side, up, y) : mix(side, floorBounce(), -y);
    // The sky is brighter round the sun.
    float towards_sun = 0.5 + 0.5 * dot(normal, frame.to_sun.xyz);
    return ambient + 0.06 * towards_sun * towards_sun * frame.sun_colour.rgb;
}

// What a surface of the given roughness mirrors: the sky above, the floor below, blurred towards their mean.
vec3 reflectedRadiance(vec3 direction, float roughness) {
    float blend = smoothstep(-0.08 - 0.5 * roughness, 0.08 + 0.5 * roughness, direction.y);
    vec3 sharp = mix(floorBounce(), skyGradient(direction), blend);
    return mix(sharp, ambientRadiance(direction), roughness);
}

// Air between the eye and a point: far things fade into the haze of the horizon.
vec3 throughAir(vec3 colour, vec3 position) {
    vec3 ray = position - frame.eye.xyz;
    float reach = 9.0 * frame.scene.w + 2.0 * length(frame.eye.xyz - frame.scene.xyz);
    float haze = 1.0 - exp(-pow(length(ray) / reach, 1.6));
    vec3 level = normalize(vec3(ray.x + 1e-6, 0.0, ray.z));
    return mix(colour, frame.sky_horizon.rgb + sunGlow(level), haze);
}
