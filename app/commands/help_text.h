// SPDX-License-Identifier: Apache-2.0
// How `--help` reads.
#pragma once
#include <CLI/CLI.hpp>
#include <initializer_list>
#include <memory>
#include <string>

namespace demolish {

/// Says what an option is without being given behind its description, not glued to the name of its type.
class HelpFormatter : public CLI::Formatter {
  public:
    std::string make_option_opts(const CLI::Option* option) const override;
    std::string make_option_desc(const CLI::Option* option) const override;
};

/// The last lines of a command's help: examples, each without the word demolish, and the exit codes.
void setExamples(CLI::App& command, std::initializer_list<const char*> examples);

}  // namespace demolish
