// SPDX-License-Identifier: Apache-2.0
// Option lines and last lines of help.
#include "app/commands/help_text.h"

namespace demolish {

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
    const std::string type = option->get_type_size() != 0 ? option->get_type_name() : "";
    return (type.empty() ? "" : " " + type) + (option->get_required() ? " (required)" : "");
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
    const std::string value = option->get_default_str();
    return option->get_description() + (value.empty() ? "" : " (default: " + value + ")");
}

void setExamples(CLI::App& command, std::initializer_list<const char*> examples) {
    std::string text = "Examples:\n";
    for (const char* example : examples) text += std::string("  demolish ") + example + "\n";
    command.footer(
        text +
        "Exit codes: 0 done, 2 usage, 3 input file, 4 device or OpenGL, 5 numerical failure, 6 output "
        "not written.");
}

}  // namespace demolish
