// SPDX-License-Identifier: Apache-2.0
#include "tests/bullet/bullet_world.h"

#include <BulletCollision/CollisionShapes/btShapeHull.h>
#include <btBulletDynamicsCommon.h>

#include <vector>

namespace demolish::bullet {
namespace {

constexpr double kStep = 1.0 / 240;
constexpr double kGravity = 9.81;

btVector3 toBullet(const glm::dvec3& v) {
    return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}

/// At most 42 corners, as Bullet advises.
std::unique_ptr<btConvexHullShape> hullOf(const Piece& piece) {
    btConvexHullShape all;
    for (const glm::dvec3& corner : piece.corners) all.addPoint(toBullet(corner), false);
    all.recalcLocalAabb();
    all.setMargin(0);
    btShapeHull simple(&all);
    simple.buildHull(0);
    auto hull = std::make_unique<btConvexHullShape>();
    for (int v = 0; v < simple.numVertices(); ++v) hull->addPoint(simple.getVertexPointer()[v], false);
    hull->recalcLocalAabb();
    hull->setMargin(btScalar(0.001));
    return hull;
}

}  // namespace

struct World::Parts {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<std::unique_ptr<btDefaultMotionState>> states;
    std::vector<std::unique_ptr<btRigidBody>> bodies;  ///< floor, pieces, balls
    size_t pieces = 0;

    btRigidBody& add(std::unique_ptr<btCollisionShape> shape, double mass, const glm::dvec3& place,
                     double friction, double restitution) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(btScalar(mass), inertia);
        states.push_back(std::make_unique<btDefaultMotionState>(
            btTransform(btQuaternion::getIdentity(), toBullet(place))));
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), states.back().get(), shape.get(),
                                                      inertia);
        info.m_friction = btScalar(friction);
        info.m_restitution = btScalar(restitution);
        shapes.push_back(std::move(shape));
        bodies.push_back(std::make_unique<btRigidBody>(info));
        world.addRigidBody(bodies.back().get());
        return *bodies.back();
    }
    ~Parts() {
        for (const auto& body : bodies) world.removeRigidBody(body.get());
    }
};

World::World(std::span<const Piece> pieces) : parts_(std::make_unique<Parts>()) {
    parts_->world.setGravity({0, btScalar(-kGravity), 0});
    parts_->add(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), btScalar(0)), 0, {0, 0, 0}, 1, 1);
    for (const Piece& piece : pieces)
        parts_->add(hullOf(piece), piece.mass, piece.centre, piece.friction, piece.restitution)
            .setActivationState(ISLAND_SLEEPING);
    parts_->pieces = pieces.size();
}
World::~World() = default;

void World::fire(const Projectile& ball) {
    constexpr double kPi = 3.14159265358979323846;
    const double mass = ball.density * 4.0 / 3 * kPi * ball.radius * ball.radius * ball.radius;
    btRigidBody& body = parts_->add(std::make_unique<btSphereShape>(btScalar(ball.radius)), mass,
                                    {ball.position.x, ball.position.y, ball.position.z}, 0.5, 0.1);
    body.setLinearVelocity(toBullet({ball.velocity.x, ball.velocity.y, ball.velocity.z}));
    body.setCcdMotionThreshold(btScalar(0.5 * ball.radius));
    body.setCcdSweptSphereRadius(btScalar(0.5 * ball.radius));
}

void World::advance(double seconds) {
    parts_->world.stepSimulation(btScalar(seconds), 1 + int(seconds / kStep + 1), btScalar(kStep));
}

double World::energy() const {
    double sum = 0;
    for (const auto& body : parts_->bodies) {
        if (body->getMass() <= 0) continue;
        const btVector3 spin = body->getWorldTransform().getBasis().transpose() * body->getAngularVelocity();
        const btVector3 inverse = body->getInvInertiaDiagLocal();
        sum += 0.5 * double(body->getMass()) * double(body->getLinearVelocity().length2()) +
               double(body->getMass()) * kGravity * double(body->getWorldTransform().getOrigin().y());
        for (int axis = 0; axis < 3; ++axis)
            sum += 0.5 * double(spin[axis] * spin[axis]) / double(inverse[axis]);
    }
    return sum;
}

glm::dvec3 World::centre(size_t piece) const {
    const btVector3& at = parts_->bodies.at(piece + 1)->getWorldTransform().getOrigin();
    return {at.x(), at.y(), at.z()};
}
glm::dquat World::turn(size_t piece) const {
    const btQuaternion q = parts_->bodies.at(piece + 1)->getWorldTransform().getRotation();
    return {q.w(), q.x(), q.y(), q.z()};
}
size_t World::pieces() const {
    return parts_->pieces;
}
std::vector<World::Ball> World::balls() const {
    std::vector<Ball> balls;
    for (size_t body = parts_->pieces + 1; body < parts_->bodies.size(); ++body) {
        const btVector3& at = parts_->bodies[body]->getWorldTransform().getOrigin();
        const auto& sphere = static_cast<const btSphereShape&>(*parts_->shapes[body]);
        balls.push_back({{at.x(), at.y(), at.z()}, double(sphere.getRadius())});
    }
    return balls;
}

}  // namespace demolish::bullet
