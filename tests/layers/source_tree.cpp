// SPDX-License-Identifier: Apache-2.0
// Reading of sources, without a parser.
#include "tests/layers/source_tree.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

namespace demolish::layers {
namespace fs = std::filesystem;
namespace {

const fs::path kRoot = DEMOLISH_SOURCE_DIR;

bool isSource(const fs::path& file) {
    static const std::set<std::string> kExtensions = {".h", ".hpp", ".cpp", ".cu", ".cuh"};
    return kExtensions.count(file.extension().string()) > 0;
}

/// Goes through a text and keeps what is code.
class Stripper {
  public:
    explicit Stripper(const std::string& text) : text_(text) {}

    std::string code() {
        while (at_ < text_.size()) step();
        return code_;
    }

  private:
    bool here(const char* word) const {
        return text_.compare(at_, std::char_traits<char>::length(word), word) == 0;
    }
    bool startsLine() const {
        const size_t begin = code_.rfind('\n') == std::string::npos ? 0 : code_.rfind('\n') + 1;
        return code_.find_first_not_of(" \t", begin) == std::string::npos;
    }
    /// Skips to behind the next `end`; keeps the line breaks.
    void skipBehind(const std::string& end) {
        const size_t found = text_.find(end, at_);
        const size_t behind = found == std::string::npos ? text_.size() : found + end.size();
        for (; at_ < behind; ++at_)
            if (text_[at_] == '\n') code_ += '\n';
    }
    void skipLine() {
        while (at_ < text_.size() && text_[at_] != '\n') {
            if (text_[at_] == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') {
                code_ += '\n';
                ++at_;
            }
            ++at_;
        }
    }
    void skipQuoted(char quote) {
        code_ += quote;
        for (++at_; at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n'; ++at_)
            if (text_[at_] == '\\') ++at_;
        code_ += quote;
        ++at_;
    }
    void step() {
        const char c = text_[at_];
        const bool after_word = at_ > 0 && std::isalnum(static_cast<unsigned char>(text_[at_ - 1])) != 0;
        if (here("//")) return skipLine();
        if (here("/*")) return skipBehind("*/");
        if (c == '#' && startsLine()) return skipLine();
        if (here("R\"(")) return skipBehind(")\"");
        if (c == '"' || (c == '\'' && !after_word)) return skipQuoted(c);  // else it parts digits
        code_ += c;
        ++at_;
    }

    const std::string& text_;
    std::string code_;
    size_t at_ = 0;
};

}  // namespace

std::vector<fs::path> sourcesUnder(const std::vector<std::string>& folders) {
    std::vector<fs::path> files;
    for (const auto& folder : folders) {
        if (!fs::exists(kRoot / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
            if (entry.is_regular_file() && isSource(entry.path())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string nameOf(const fs::path& file) {
    return fs::relative(file, kRoot).generic_string();
}

std::vector<std::string> linesOf(const fs::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string codeOf(const std::string& text) {
    return Stripper(text).code();
}

std::string codeOfFile(const fs::path& file) {
    std::ifstream in(file);
    return codeOf(std::string(std::istreambuf_iterator<char>(in), {}));
}

std::vector<std::string> includesIn(const std::vector<std::string>& lines) {
    static const std::regex kInclude(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    std::vector<std::string> headers;
    std::smatch match;
    for (const auto& line : lines)
        if (std::regex_search(line, match, kInclude)) headers.push_back(match[1]);
    return headers;
}

}  // namespace demolish::layers
