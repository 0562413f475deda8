// SPDX-License-Identifier: Apache-2.0
// A shot of one model file, and how long the lengths of model files are.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/shot.h"

namespace demolish {

/// m, mm, cm, in, ft.
const std::vector<std::string>& lengthUnitNames();
/// m; none for another name.
std::optional<double> lengthUnitOf(const std::string& name);

/// The name of one of these, "" for 0.
std::string lengthUnitName(double metres);

/// How long 1 in the file is: its format says it, or part.unit does.
bool hasKnownSize(const std::filesystem::path& model, const ModelPart& part);
/// Why a model of this name takes no unit, a sentence without full stop; "" where it needs one.
std::string refusalOfUnit(const std::filesystem::path& model);

/// Whom a sentence advises: someone at a terminal has options, someone at the window has panels.
enum class Advised { kTerminal, kWindow };

/// What there is to say of the size of the shot's model, which as a body lies between `low` and `high` (m):
/// that it is implausible, or that nobody said it, and what to do. "": nothing; a sentence without full stop.
std::string sizeRemark(const Shot& shot, const Double3& low, const Double3& high, Advised advised);

/// Stands on the floor as large as its file says, 1 m high where that says nothing, hit by the ball that
/// breaks it. `material`: empty, the usual one. Throws InputFileError (the material).
Shot modelShot(const std::filesystem::path& model, const std::string& material = "");
/// The same, with the lengths of the file in units of `unit` m; 0: not known.
void setUnit(Shot& shot, double unit);

}  // namespace demolish
