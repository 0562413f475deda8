// SPDX-License-Identifier: Apache-2.0
#include "app/reading/set_text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/reading/mesh_stream.h"

namespace demolish {
namespace {

using Json = nlohmann::json;

Json jsonOf(const Double3& v) {
    return {v.x, v.y, v.z};
}

double numberOf(const Json& json) {
    const double number = json.get<double>();
    if (!std::isfinite(number)) throw BrokenStream("a number is not finite");
    return number;
}

Double3 pointOf(const Json& json) {
    return {numberOf(json.at(0)), numberOf(json.at(1)), numberOf(json.at(2))};
}

ModelSet setOf(const Json& json) {
    ModelSet set;
    if (json.at("things").size() > kMostThings) throw BrokenStream("there are too many things");
    for (const Json& thing : json.at("things"))
        set.things.push_back({thing.at("node").get<std::string>(), pointOf(thing.at("low")),
                              pointOf(thing.at("high")), thing.at("triangles").get<size_t>()});
    if (json.contains("camera")) {
        const Json& camera = json.at("camera");
        set.camera = SetCamera{pointOf(camera.at("eye")), pointOf(camera.at("target")),
                               numberOf(camera.at("field_of_view"))};
    }
    if (json.contains("sun")) set.sun_direction = pointOf(json.at("sun"));
    return set;
}

}  // namespace

std::string setText(const ModelSet& set) {
    Json json;
    json["things"] = Json::array();
    for (size_t i = 0; i < std::min(set.things.size(), kMostThings); ++i) {
        const SetThing& thing = set.things[i];
        json["things"].push_back({{"node", thing.node},
                                  {"low", jsonOf(thing.low)},
                                  {"high", jsonOf(thing.high)},
                                  {"triangles", thing.triangles}});
    }
    if (set.camera)
        json["camera"] = {{"eye", jsonOf(set.camera->eye)},
                          {"target", jsonOf(set.camera->target)},
                          {"field_of_view", set.camera->field_of_view}};
    if (set.sun_direction) json["sun"] = jsonOf(*set.sun_direction);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

ModelSet setOfText(const std::string& text) {
    try {
        return setOf(Json::parse(text));
    } catch (const Json::exception&) {
        throw BrokenStream("this is no set");
    }
}

}  // namespace demolish
