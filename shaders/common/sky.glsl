// The sky: its radiance in a direction, and the light it sends onto a surface together with the floor.
vec3 skyGradient(vec3 direction) {
    float height = max(direction.y, 0.0);
    return mix(frame.sky_horizon.rgb, frame.sky_zenith.rgb, 1.0 - exp(-4.5 * height));
}

vec3 skyRadiance(vec3 direction) {
    float cosine = clamp(dot(direction, frame.to_sun.xyz), 0.0, 1.0);
    float glow = 0.16 * pow(cosine, 6.0) + 0.35 * pow(cosine, 60.0);
    return skyGradient(direction) + glow * 0.35 * frame.sun_colour.rgb;
}

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
    return mix(colour, skyRadiance(normalize(vec3(ray.x, 0.0, ray.z) + vec3(1e-6, 0.0, 0.0))), haze);
}
