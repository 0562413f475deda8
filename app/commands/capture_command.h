// demolish capture: breaks a model without a window and writes pictures, a film and a report.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "app/commands/shot_options.h"

namespace demolish {

struct CaptureOptions {
    ShotOptions shot;
    double frames = 150;
    double camera_yaw = 0, camera_pitch = 0;  ///< degrees, from the shot's camera about its target
    std::string out, video, report, view = "surface";
};

void addCaptureCommand(CLI::App& app, CaptureOptions& options);

}  // namespace demolish
