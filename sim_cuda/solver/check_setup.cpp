// SPDX-License-Identifier: Apache-2.0
// Refuses what cannot be simulated, in one sentence each, before anything is allocated.
#include <algorithm>
#include <cmath>
#include <optional>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {
namespace {

/// m, of round colliders.
constexpr double kLeastRadius = 1e-3, kMostRadius = 1e4;

Vec3<double> vec(const Double3& v) {
    return {v.x, v.y, v.z};
}

void demand(bool condition, const std::string& sentence) {
    if (!condition) throw UsageError(sentence);
}

void demandRange(double value, double low, double high, const std::string& name) {
    demand(value >= low && value <= high, name + " is " + std::to_string(value) + ", it must lie between " +
                                              std::to_string(low) + " and " + std::to_string(high) + ".");
}

void demandFinite(const Double3& v, const std::string& name) {
    demand(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), name + " is not a finite number.");
}

void demandUnit(const Quaternion& q, const std::string& name) {
    demandRange(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 0.999, 1.001, "The square of " + name);
}

void checkMaterial(const Material& material) {
    const std::string of = " of material \"" + material.name + "\"";
    demandRange(material.density, 1, 1e5, "Density" + of);
    demandRange(material.youngs_modulus, 1, 1e13, "Young's modulus" + of);
    demandRange(material.poisson_ratio, 0, 0.49, "Poisson ratio" + of);
    demandRange(material.friction, 0, 1.5, "Friction" + of);
    demandRange(material.restitution, 0.05, 1, "Restitution" + of);
    demandRange(material.rolling_friction, 0, 1, "Rolling friction" + of);
    demandRange(material.damping_ratio, 0, 0.6, "Damping ratio" + of);
    demandRange(material.critical_velocity, 1e-6, 1e9, "Critical velocity" + of);
    demandRange(material.beta, 1e-3, 1e3, "Beta" + of);
    demandRange(material.weibull_modulus, 0, 100, "Weibull modulus" + of);
    demandRange(material.tough_factor, 1, 100, "Tough factor" + of);
    demandRange(material.adhesion_energy, 0, 1e3, "Adhesion energy" + of);
    demandRange(material.shear_ratio, 0, 1, "Shear ratio" + of);
    demandRange(material.bond_ratio, 0.1, 0.9, "Bond radius ratio" + of);
    demandRange(material.fracture_energy, 0, 1e9, "Fracture energy" + of);
    demandRange(material.debris.grit_per_m2, 0, 1e6, "Grit (grains above 1 mm a m^2)" + of);
    demandRange(material.debris.dust_m2_per_m2, 0, 10, "Dust (m^2 a m^2)" + of);
    demandRange(material.debris.sparks, 0, 1, "Sparks" + of);
    demandRange(material.break_waves, 0, 0.6, "Waves of breaks" + of);
}

void checkBody(const BodyInstance& instance) {
    demand(instance.body != nullptr && !instance.body->particles.empty(),
           "A body of the scene has no particles.");
    checkMaterial(instance.material);
    demandFinite(instance.position, "A body's position");
    demandFinite(instance.velocity, "A body's velocity");
    demandFinite(instance.angular_velocity, "A body's angular velocity");
    demandUnit(instance.rotation, "a body's rotation");
}

void checkShape(const Plane& plane) {
    const Double3& n = plane.normal;
    demandRange(n.x * n.x + n.y * n.y + n.z * n.z, 0.999, 1.001, "The square of a plane's normal");
    demandRange(plane.offset, -1e6, 1e6, "The offset (m) of a plane");
}

void checkShape(const Box& box) {
    for (const double edge : {box.size.x, box.size.y, box.size.z})
        demandRange(edge, 1e-3, 1e4, "An edge (m) of a box");
    demandFinite(box.position, "A box's position");
    demandUnit(box.rotation, "a box's rotation");
}

void checkShape(const Sphere& ball) {
    demandRange(ball.radius, kLeastRadius, kMostRadius, "The radius (m) of a sphere");
    demandFinite(ball.position, "A sphere's position");
}

void checkShape(const Capsule& rod) {
    demandRange(rod.radius, kLeastRadius, kMostRadius, "The radius (m) of a capsule");
    demandFinite(rod.from, "An end of a capsule");
    demandFinite(rod.to, "An end of a capsule");
    demandRange(length(vec(rod.to) - vec(rod.from)), 1e-3, 1e4,
                "The length (m) of a capsule between its ends");
}

void checkShape(const MeshShape& shape) {
    demand(shape.mesh != nullptr && !shape.mesh->nodes.steps.empty(), "A mesh collider has no mesh.");
    demandRange(shape.scale, 1e-9, 1e9, "The scale of a mesh");
    demandFinite(shape.position, "A mesh's position");
    demandUnit(shape.rotation, "a mesh's rotation");
}

void checkCollider(const Collider& collider) {
    std::visit([](const auto& shape) { checkShape(shape); }, collider.shape);
    if (collider.friction) demandRange(*collider.friction, 0, 1.5, "Friction of a collider");
    if (collider.restitution) demandRange(*collider.restitution, 0.05, 1, "Restitution of a collider");
}

void checkEffects(const EffectsSettings& effects) {
    for (const double amount : {effects.grit, effects.dust, effects.sparks})
        demandRange(amount, 0, 10, "An amount of grit, dust or sparks");
    demandRange(effects.finest, 0.01, 0.3, "The smallest grain (spacings)");
    demandRange(effects.grains, 1, kMaxGrains, "The number of grains");
    demandRange(effects.puffs, 1, kMaxPuffs, "The number of puffs");
}

void checkParams(const SolverParams& params) {
    checkEffects(params.effects);
    demandRange(params.frame_time, 1e-9, 10, "Frame time (s)");
    demandRange(params.substeps, 1, 1e7, "Substeps");
    demandRange(params.step_safety, 1e-5, 1, "Step safety");
    demandRange(params.settle_time, 0, 100, "Settling time (s)");
    demandRange(params.scene_radius, 1e-6, 1e6, "Scene radius (m)");
    demandFinite(params.gravity, "Gravity");
    demand(params.colliders.size() <= kMaxColliders,
           "A scene has at most " + std::to_string(kMaxColliders) + " colliders, its floor among them.");
    demandRange(params.wall_friction, -1, 1.5, "Friction of the colliders");
    demand(!params.preset_pieces || params.hand_over,
           "Preset pieces move as rigid bodies: they need hand-over.");
    demandRange(params.wall_stiffness, 1e-3, 1, "Stiffness of the colliders");
    for (const Collider& collider : params.colliders) checkCollider(collider);
}

/// Number of the collider that the point lies in, if it does.
std::optional<uint32_t> colliderRound(const ColliderSet<double>& colliders, const Vec3<double>& point) {
    std::optional<uint32_t> found;
    forEachCollider(colliders, point, [&](uint32_t c, const TangentPlane<double>& tangent) {
        if (tangent.distance < 0 && !found) found = c;
    });
    return found;
}

const char* nameOf(const Plane&) {
    return "a plane";
}
const char* nameOf(const Box&) {
    return "a box";
}
const char* nameOf(const Sphere&) {
    return "a sphere";
}
const char* nameOf(const Capsule&) {
    return "a capsule";
}
const char* nameOf(const MeshShape&) {
    return "a mesh";
}

/// What is held stands wherever it stands, a base in the ground. Half a spacing is as far as particles reach.
bool isHeld(const SceneSetup& setup, uint32_t body, const Vec3<double>& point) {
    const double radius = 0.5 * setup.bodies[body].body->spacing;
    return std::any_of(setup.anchors.begin(), setup.anchors.end(),
                       [&](const Anchor& anchor) { return reaches(anchor, body, point, radius); });
}

void checkStart(const SceneSetup& setup, uint32_t number, const ColliderSet<double>& set) {
    const BodyInstance& instance = setup.bodies[number];
    const std::vector<Collider>& colliders = setup.params.colliders;
    const Quaternion& r = instance.rotation;
    for (const Particle& particle : instance.body->particles) {
        const Vec3<double> at =
            vec(instance.position) + rotate(Quat<double>{r.x, r.y, r.z, r.w}, vec(particle.seed));
        const auto inside = colliderRound(set, at);
        if (!inside || isHeld(setup, number, at)) continue;
        const char* name =
            std::visit([](const auto& shape) { return nameOf(shape); }, colliders[*inside].shape);
        throw InputFileError("Body " + std::to_string(number) + " of the scene starts inside its collider " +
                             std::to_string(*inside) + ", " + name +
                             " (bodies are counted from 0, and collider 0 is the floor); move one of them.");
    }
}

void checkPath(const MotionPath& path) {
    double before = 0;
    for (const PathKey& key : path.keys) {
        demand(std::isfinite(key.time) && key.time > before,
               "The times of a path's keys must be above 0 and ascend.");
        before = key.time;
        demandFinite(key.way, "A way of a path");
        demandFinite(key.turn, "A turn of a path");
    }
}

void checkRegion(const Anchor::Everything&) {}
void checkRegion(const Box& box) {
    checkShape(box);
}
void checkRegion(const Sphere& ball) {
    checkShape(ball);
}

void checkAnchors(const SceneSetup& setup) {
    size_t paths = 0;
    for (const Anchor& anchor : setup.anchors) {
        std::visit([](const auto& region) { checkRegion(region); }, anchor.region);
        demand(anchor.body.value_or(0) < setup.bodies.size(), "An anchor is of a body that is not there.");
        demandFinite(anchor.pivot, "An anchor's pivot");
        checkPath(anchor.path);
        paths += anchor.path.keys.empty() ? 0 : 1;
    }
    demand(paths <= kMaxPaths,
           "A scene has at most " + std::to_string(kMaxPaths) + " anchors and bodies that follow a path.");
}

}  // namespace

void checkProjectile(const Projectile& projectile) {
    demandRange(projectile.radius, 1e-9, 1e3, "Projectile radius (m)");
    demandRange(projectile.density, 1e-3, 1e6, "Projectile density");
    demandRange(projectile.stiffness_factor, 1e-3, 1e3, "Projectile stiffness factor");
    demand(projectile.start_time >= 0, "A projectile starts before the simulation does.");
    demandFinite(projectile.position, "A projectile's position");
    demandFinite(projectile.velocity, "A projectile's velocity");
}

void checkStart(const Projectile& projectile, const std::vector<Collider>& colliders) {
    demand(!colliderRound(makeColliderSet<double>(colliders), vec(projectile.position)),
           "A projectile starts inside a collider.");
}

void checkSetup(const SceneSetup& setup) {
    demand(!setup.bodies.empty(), "The scene has no body.");
    for (const BodyInstance& instance : setup.bodies) checkBody(instance);
    demand(setup.projectiles.size() <= kMaxProjectiles,
           "A run has at most " + std::to_string(kMaxProjectiles) + " projectiles.");
    for (const Projectile& projectile : setup.projectiles) checkProjectile(projectile);
    checkParams(setup.params);
    const std::vector<Collider>& colliders = setup.params.colliders;
    for (const Projectile& projectile : setup.projectiles) checkStart(projectile, colliders);
    const auto set = makeColliderSet<double>(colliders);
    checkAnchors(setup);
    for (const BodyInstance& instance : setup.bodies)
        demand(!setup.mortar || !instance.body->geometry.exterior_indices.empty(),
               "Mortar joins the outsides of bodies, and one has none.");
    for (uint32_t b = 0; b < setup.bodies.size(); ++b) checkStart(setup, b, set);
}

}  // namespace demolish
