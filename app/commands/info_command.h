// SPDX-License-Identifier: Apache-2.0
// demolish info: what this machine has, and how frames would travel.
#pragma once

namespace CLI {
class App;
}

namespace demolish {

void addInfoCommand(CLI::App& app);

}  // namespace demolish
