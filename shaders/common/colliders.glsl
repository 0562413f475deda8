// SPDX-License-Identifier: Apache-2.0
// Static solids as rays meet them; the C++ side is engine/passes/collider_pass.cpp. All are convex.
struct Collider {
    vec4 axis[3];  // xyz: unit; w: half the size along it, m
    vec4 centre;   // xyz: m; w: shape, engine::ColliderShape
    vec4 colour;   // rgb: linear; a: 1, or 0 where it is the floor's
};
layout(std140, binding = 1) uniform Colliders {
    Collider colliders[8];
    uint collider_count;
};

// Where a ray enters and leaves a solid, in lengths of the ray; it misses what it leaves before it enters.
struct Crossing {
    float enter, leave;
    vec3 normal;  // unit, outward, where it enters
    uint solid;   // number of the collider
};

const float kNoCollider = 1e30;

// In the box's own frame.
Crossing crossBox(vec3 from, vec3 ray, vec3 half_size) {
    vec3 per_length = 1.0 / mix(ray, vec3(1e-12), lessThan(abs(ray), vec3(1e-12)));
    vec3 middle = -from * per_length, reach = half_size * abs(per_length);
    vec3 first = middle - reach, last = middle + reach;
    float enter = max(first.x, max(first.y, first.z)), leave = min(last.x, min(last.y, last.z));
    vec3 face = first.x == enter ? vec3(1.0, 0.0, 0.0) : first.y == enter ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    return Crossing(enter, leave, -sign(per_length) * face, 0u);
}

// A ball about the origin, or, with z = 0 in both, a round rod along z.
Crossing crossRound(vec3 from, vec3 ray, float radius) {
    float squared = max(dot(ray, ray), 1e-24), middle = -dot(from, ray) / squared;
    vec3 nearest = from + middle * ray;
    float left = radius * radius - dot(nearest, nearest), half_way = sqrt(max(left, 0.0) / squared);
    return Crossing(left < 0.0 ? kNoCollider : middle - half_way, left < 0.0 ? -kNoCollider : middle + half_way, vec3(0.0), 0u);
}

// The rod between its ends and the balls at them; `line`: m, from the middle to the centre of each ball.
Crossing crossCapsule(vec3 from, vec3 ray, float radius, float line) {
    Crossing rod = crossRound(vec3(from.xy, 0.0), vec3(ray.xy, 0.0), radius);
    float along = abs(ray.z) < 1e-12 ? 1e-12 : ray.z, middle = -from.z / along, reach = line / abs(along);
    rod.enter = max(rod.enter, middle - reach);
    rod.leave = min(rod.leave, middle + reach);
    Crossing whole = Crossing(kNoCollider, -kNoCollider, vec3(0.0), 0u);
    for (int part = 0; part < 3; ++part) {
        Crossing own = rod;
        if (part > 0) own = crossRound(from - vec3(0.0, 0.0, part == 1 ? line : -line), ray, radius);
        if (own.enter > own.leave) continue;
        whole.enter = min(whole.enter, own.enter);
        whole.leave = max(whole.leave, own.leave);
    }
    vec3 at = from + whole.enter * ray;
    whole.normal = (at - vec3(0.0, 0.0, clamp(at.z, -line, line))) / radius;
    return whole;
}

const float kBox = 0.0, kPlane = 1.0, kSphere = 2.0;

Crossing crossCollider(uint c, vec3 from, vec3 ray) {
    mat3 axes = mat3(colliders[c].axis[0].xyz, colliders[c].axis[1].xyz, colliders[c].axis[2].xyz);
    vec3 half_size = vec3(colliders[c].axis[0].w, colliders[c].axis[1].w, colliders[c].axis[2].w);
    vec3 own_from = (from - colliders[c].centre.xyz) * axes, own_ray = ray * axes;
    Crossing own;
    if (colliders[c].centre.w >= kSphere) {
        own = crossCapsule(own_from, own_ray, half_size.x, half_size.z - half_size.x);
    } else {
        own = crossBox(own_from, own_ray, half_size);
        if (colliders[c].centre.w == kPlane && own.normal.z <= 0.0) own.leave = own.enter - 1.0;
    }
    return Crossing(own.enter, own.leave, axes * own.normal, c);
}

// The first that a ray from a point enters; beyond kNoCollider: none. A point inside a solid does not see it.
Crossing firstCollider(vec3 from, vec3 ray) {
    Crossing nearest = Crossing(kNoCollider, kNoCollider, vec3(0.0), 0u);
    for (uint c = 0u; c < collider_count; ++c) {
        Crossing found = crossCollider(c, from, ray);
        if (found.enter > 0.0 && found.enter <= found.leave && found.enter < nearest.enter) nearest = found;
    }
    return nearest;
}
Crossing nearestCollider(vec3 ray) { return firstCollider(frame.eye.xyz, ray); }

// What the sun's map holds of a solid: a depth between its lit side and its far one. It casts the same shadow, and the lit side
// keeps clear of it. `p`: m, on the ray of the sun. Returns whether the ray meets the solid.
bool shadowPoint(uint c, vec3 p, out vec3 caster) {
    Crossing found = crossCollider(c, p, -frame.to_sun.xyz);
    caster = p - 0.5 * (found.enter + found.leave) * frame.to_sun.xyz;
    return found.enter <= found.leave;
}
