// SPDX-License-Identifier: Apache-2.0
// The balls of a shot: which one comes when, and how it flies so that it hits as the shot says.
#pragma once
#include <vector>

#include "app/session/shot.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// A plate on the floor, with next to no side to hit: balls that name no direction come from above.
bool liesFlat(const BreakableBody& body);

/// Unit: the way that is chosen; else across the longer horizontal side, level, or from above onto what lies
/// flat.
Double3 flightDirection(const Double3& chosen, const BreakableBody& body);

/// m, of the shot's ball where a TimedBall names none.
double ballRadius(const Shot& shot, const BreakableBody& body);

/// The balls that the shot fires by itself, in order of time: Shot::balls, or the one of Shot::impact. None
/// when nothing is to hit the bodies.
std::vector<TimedBall> ballsOf(const Shot& shot);

/// The ball that comes with the shot's full velocity; the first of several, the one of Shot::impact if there
/// is no list.
TimedBall fastestBall(const Shot& shot);

/// True if a ball should start now: its flight has begun, or would be less than half left after the next
/// step of `step` s.
bool dueToStart(const TimedBall& ball, double now, double step);

struct ThrownBall {
    Projectile ball;
    double flight = 0;  ///< s until it touches
};
/// A ball that reaches its body's surface after `flight` s with its velocity, gravity on the way included; or
/// after a shorter flight, where that one would begin below the floor. The body counts where the setup places
/// it.
ThrownBall makeBall(const Shot& shot, const SceneSetup& setup, const TimedBall& ball, double flight);

/// Where the fastest ball is aimed at a body so placed, or what of it the floor meets first.
ShotAim aimOf(const Shot& shot, const SceneBody& place, const SolidMeshInfo& body);

/// A ball that passes `target` after a short flight from the side of `from`, with the shot's velocity and
/// radius there.
Projectile makeBallAt(const Shot& shot, const BreakableBody& body, const Double3& from,
                      const Double3& target);

}  // namespace demolish
