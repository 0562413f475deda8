// SPDX-License-Identifier: Apache-2.0
// Formatting and quoting.
#include "app/commands/text_table.h"

#include <cstdarg>
#include <cstdio>

#include "app/commands/one_sentence.h"

namespace demolish {
namespace {

std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

std::string formatted(const char* pattern, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

std::string csvLine(const std::vector<std::string>& fields) {
    std::string line;
    for (size_t i = 0; i < fields.size(); ++i) {
        if (i > 0) line += ',';
        line += csvField(fields[i]);
    }
    return line + "\n";
}

std::string modelName(const std::filesystem::path& model) {
    return oneSentence(model.filename().string());
}

}  // namespace demolish
