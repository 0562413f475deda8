// SPDX-License-Identifier: Apache-2.0
// Session status as JSON.
#include "app/commands/session_json.h"

#include <nlohmann/json.hpp>

#include "app/commands/threshold_json.h"
#include "app/session/json_text.h"

namespace demolish {

std::string sessionJson(const Session& session) {
    const SessionStatus status = session.status();
    nlohmann::ordered_json json;
    json["scene"] = session.shot().scene;
    json["impact_velocity"] = session.shot().impact.velocity;
    json["threshold"] = thresholdJson(session.shot(), *session.built().body);
    json["material"] = session.shot().material_name;
    json["method"] = methodName(session.shot().method);
    json["device"] = session.built().solver->deviceName();
    json["particle_size"] = status.particle_size;
    json["particles"] = status.stats.particles;
    json["bonds_broken"] = status.stats.bonds_broken;
    json["bonds_parted"] = status.stats.bonds_parted;
    json["fragments"] = status.stats.fragments;
    json["time"] = status.stats.time;
    json["rebuilding"] = status.waiting || status.rebuilding;
    json["playing"] = status.playing;
    json["frame_share"] = status.frame_share.value_or(0);
    json["replaying"] = status.replaying;
    json["cursor"] = status.cursor;
    json["recorded_frames"] = status.recorded_frames;
    json["projectiles"] = session.spheres().size();
    json["transfer"] = status.transfer;
    json["message"] = status.message;
    return jsonText(json, 2) + "\n";
}

}  // namespace demolish
