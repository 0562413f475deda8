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
    std::string out, video, report, view = "surface";
};

void addCaptureCommand(CLI::App& app, CaptureOptions& options);

}  // namespace demolish
