// SPDX-License-Identifier: Apache-2.0
// Session status as JSON.
#include "app/commands/session_json.h"

#include <nlohmann/json.hpp>

#include "app/commands/threshold_json.h"
#include "app/session/json_text.h"
#include "app/session/paint_names.h"
#include "app/session/shot_bodies.h"

namespace demolish {

namespace {

nlohmann::ordered_json bodiesJson(const Shot& shot) {
    auto list = nlohmann::ordered_json::array();
    for (size_t b = 0; b < shot.bodies.size(); ++b) {
        const SceneBody& body = shot.bodies[b];
        const Double3& p = body.position;
        list.push_back({{"name", nameOf(shot, b)},
                        {"position_m", {shot.height * p.x, shot.height * p.y, shot.height * p.z}},
                        {"yaw_rad", body.yaw},
                        {"material", body.material ? body.material->name : shot.material_name},
                        {"hidden", body.hidden},
                        {"locked", body.locked}});
    }
    return list;
}

}  // namespace

std::string sessionJson(const Session& session) {
    const SessionStatus status = session.status();
    nlohmann::ordered_json json;
    json["scene"] = session.shot().scene;
    json["impact_velocity"] = session.shot().impact.velocity;
    json["threshold"] = thresholdJson(session.shot(), *session.built().body);
    json["material"] = session.shot().material_name;
    json["inner_material"] = session.shot().inner_material;
    json["repair"] = repairModeName(session.shot().repair.mode);
    const auto& painted = session.shot().painted;
    json["painted"] = painted ? paintChannelNames()[static_cast<size_t>(painted->channel)] : "";
    json["body_size"] = status.body_size;
    json["size_remark"] = status.size_remark;
    json["bodies"] = bodiesJson(session.shot());
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
