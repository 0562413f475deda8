// SPDX-License-Identifier: Apache-2.0
// What code, scenes, tests and pages refer to is there: sections of the pages in docs ("physics B.2", "D 14",
// "geometry 2.4 g"), files by name, links and their anchors. READMEs stay guides: short.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {
namespace fs = std::filesystem;
const fs::path kRoot = DEMOLISH_SOURCE_DIR;
constexpr size_t kReadmeLines = 150, kReadmeWords = 1200;

std::string contentOf(const fs::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// All but this one, whose examples lead nowhere.
std::vector<fs::path> filesWithReferences() {
    static const std::set<std::string> kExtensions = {".h",     ".cpp",  ".cu",   ".cuh",  ".glsl",
                                                      ".comp",  ".vert", ".frag", ".toml", ".txt",
                                                      ".cmake", ".sh",   ".md"};
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kRoot))
        if (entry.is_regular_file() && kExtensions.count(entry.path().extension().string()))
            files.push_back(entry.path());
    for (const char* folder : {"app", "assets", "cmake", "docs", "engine", "shaders", "sim_cuda", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
            if (entry.is_regular_file() && kExtensions.count(entry.path().extension().string()))
                files.push_back(entry.path());
    std::erase_if(files, [](const fs::path& file) { return file.filename() == "reference_test.cpp"; });
    std::sort(files.begin(), files.end());
    return files;
}

bool isPage(const fs::path& file) {
    return file.extension() == ".md";
}

/// The text on one line, without what begins a line of a comment: a reference may go on in the next line.
std::string unbroken(const std::string& text) {
    static const std::regex kLineStart(R"(\n[ \t]*(///?<?|#|\*)?[ \t]*)");
    return std::regex_replace(text, kLineStart, " ");
}

/// Sections of a page: "A.6", "2.4", "D"; items of a list below one: "D 14", "2.4 g"; equations: "(E1)".
std::set<std::string> sectionsOf(const std::string& page) {
    static const std::regex kHeading(R"(^#+ ([A-E](\.\d+)?|\d+(\.\d+)*)[. ].*)");
    static const std::regex kItem(R"(^(- \*\*([a-g])\.\*\*|(\d+)\.) .*)");
    static const std::regex kEquation(R"(\(E\d\))");
    std::set<std::string> sections;
    std::string section;
    std::istringstream in(page);
    for (std::string line; std::getline(in, line);) {
        std::smatch found;
        if (std::regex_match(line, found, kHeading))
            sections.insert(section = found[1]);
        else if (std::regex_match(line, found, kItem))
            sections.insert(section + " " + found[2].str() + found[3].str());
        for (auto it = std::sregex_iterator(line.begin(), line.end(), kEquation);
             it != std::sregex_iterator(); ++it)
            sections.insert(it->str());
    }
    return sections;
}

const std::map<std::string, std::set<std::string>>& pages() {
    static const auto kPages = [] {
        std::map<std::string, std::set<std::string>> pages;
        for (const auto& entry : fs::directory_iterator(kRoot / "docs"))
            if (isPage(entry.path()))
                pages[entry.path().stem().string()] = sectionsOf(contentOf(entry.path()));
        return pages;
    }();
    return kPages;
}

struct Reference {
    std::string page, section;
};

/// Reads what follows a page's name: "A.2, A.5", "D 1-6, 15", "2.4 e-g", "1 a-e", "C.3, item 4", "E1-E4".
class SectionList {
  public:
    SectionList(std::string page, const std::string& text) : page_(std::move(page)), text_(text) {}

    std::vector<Reference> read() {
        accept("(,)? ?(decision|section)? ?");
        while (readOne() && accept("(, | and |-|–|; ?)(item |test )?")) {
        }
        return found_;
    }

  private:
    bool readOne() {
        if (const auto equation = accept(R"(\(?E(\d)\)?(?![.\d]))")) return add("(E" + (*equation)[1] + ")");
        if (const auto lettered = accept(R"(([A-E])(\.| )?(\d+)?(?![\w*]))")) {
            const std::string& number = (*lettered)[3];
            letter_ = (*lettered)[1];
            if (number.empty() || has(letter_ + "." + number))
                return add(letter_ + (number.empty() ? "" : "." + number));
            return add(letter_ + " " + number);
        }
        if (const auto number = accept(R"((\d+(\.\d+)*)(?![\w.]*[a-zA-Z%]))")) return addNumber((*number)[1]);
        if (const auto both = accept(R"((\d+(\.\d+)*) ?([a-z])\b)")) {
            item_of_ = (*both)[1];
            return add(item_of_ + " " + (*both)[3]);
        }
        if (const auto item = item_of_.empty() ? std::nullopt : accept(R"(([a-z])\b)"))
            return add(item_of_ + " " + (*item)[1]);
        return false;
    }
    /// "2.4" is a section, "2.4 g" its item; after "D 1" another number is an item of D; "0.1" item 1 of 0.
    bool addNumber(const std::string& number) {
        if (!letter_.empty())
            return add((section_of_item_.empty() ? letter_ : section_of_item_) + " " + number);
        item_of_ = number;
        if (const auto item = accept(R"( ?([a-z])\b)")) return add(number + " " + (*item)[1]);
        const size_t dot = number.rfind('.');
        if (dot != std::string::npos && !has(number))
            return add(number.substr(0, dot) + " " + number.substr(dot + 1));
        return add(number);
    }
    bool add(const std::string& section) {
        found_.push_back({page_, section});
        if (section.find(' ') == std::string::npos && !letter_.empty() && section.size() > 1)
            section_of_item_ = section;
        return true;
    }
    bool has(const std::string& section) const {
        const auto page = pages().find(page_);
        return page != pages().end() && page->second.count(section) > 0;
    }
    std::optional<std::vector<std::string>> accept(const std::string& pattern) {
        static std::map<std::string, std::regex> compiled;
        const auto regex = compiled.try_emplace(pattern, pattern).first;
        std::smatch match;
        const std::string rest = text_.substr(at_, 60);
        if (!std::regex_search(rest, match, regex->second, std::regex_constants::match_continuous))
            return std::nullopt;
        at_ += size_t(match.length());
        return std::vector<std::string>(match.begin(), match.end());
    }

    std::string page_;
    const std::string& text_;
    size_t at_ = 0;
    std::string letter_, item_of_, section_of_item_;
    std::vector<Reference> found_;
};

/// Names of pages with the sections that follow them, and sections alone: A to D of physics, E of models.
std::vector<Reference> referencesIn(const std::string& text) {
    static const std::regex kNamed(
        R"(\b(physics|models|geometry|frame[_ ]facts)( sheet)? (?=[A-E0-9])|\b(architecture),? (?=(decision )?\d)|)"
        R"(\b(physics|models|geometry|assets|architecture|frame_facts|looks|experience|performance|pipeline))"
        R"(\.md(`?\]\([^)]*\)|`)?,? (?=[A-E0-9]))");
    static const std::regex kAlone(R"((^|[^\w.])([A-E])\.(\d+)\b)");
    std::vector<Reference> all;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), kNamed); it != std::sregex_iterator();
         ++it) {
        std::string page = (*it)[1].str() + (*it)[3].str() + (*it)[5].str();
        std::replace(page.begin(), page.end(), ' ', '_');
        const std::string rest = text.substr(size_t(it->position() + it->length()), 200);
        for (const Reference& reference : SectionList(page, rest).read()) all.push_back(reference);
    }
    for (auto it = std::sregex_iterator(text.begin(), text.end(), kAlone); it != std::sregex_iterator(); ++it)
        for (const Reference& reference :
             SectionList((*it)[2] == "E" ? "models" : "physics", (*it)[2].str() + "." + (*it)[3].str())
                 .read())
            all.push_back(reference);
    return all;
}

std::string withoutCode(const std::string& page) {
    static const std::regex kFence("```[^`]*```");
    return std::regex_replace(page, kFence, "");
}

/// The anchors that a page's headings get.
std::set<std::string> anchorsOf(const fs::path& page) {
    std::set<std::string> anchors;
    std::istringstream in(contentOf(page));
    for (std::string line; std::getline(in, line);) {
        if (line.rfind('#', 0) != 0) continue;
        std::string anchor;
        for (const char c : line.substr(line.find(' ') + 1))
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || (c & 0x80))
                anchor += char(std::tolower(static_cast<unsigned char>(c)));
            else if (c == ' ')
                anchor += '-';
        anchors.insert(anchor);
    }
    return anchors;
}

TEST(References, LeadToSectionsThatExist) {
    size_t count = 0;
    for (const fs::path& file : filesWithReferences())
        for (const Reference& reference : referencesIn(unbroken(contentOf(file)))) {
            const auto page = pages().find(reference.page);
            const bool known = page != pages().end() && page->second.count(reference.section) > 0;
            EXPECT_TRUE(known) << fs::relative(file, kRoot).string() << ": docs/" << reference.page
                               << ".md has no section " << reference.section;
            ++count;
        }
    EXPECT_GT(count, 250u);
}

/// THIRD_PARTY.md is made with a bundle.
TEST(References, NamePagesThatExist) {
    static const std::regex kName(R"([\w./-]*\b(\w+\.md|[\w/]+/README)\b)");
    for (const fs::path& file : filesWithReferences()) {
        const std::string text = contentOf(file);
        if (text.find(".md") == std::string::npos && text.find("/README") == std::string::npos) continue;
        for (auto it = std::sregex_iterator(text.begin(), text.end(), kName); it != std::sregex_iterator();
             ++it) {
            std::string name = it->str();
            if (name.find("THIRD_PARTY.md") != std::string::npos) continue;
            if (name.size() < 3 || name.substr(name.size() - 3) != ".md") name += ".md";
            bool found = fs::exists(kRoot / name) || fs::exists(kRoot / "docs" / name);
            for (fs::path folder = file.parent_path(); !found && folder != kRoot.parent_path();
                 folder = folder.parent_path())
                found = fs::exists(folder / name);
            EXPECT_TRUE(found) << fs::relative(file, kRoot).string() << " speaks of " << name;
        }
    }
}

/// What stands in `backquotes` and looks like a file of ours, with or without its folder.
TEST(References, NameFilesThatExist) {
    static const std::regex kName(R"(`([\w./-]+\.(h|cpp|cu|cuh|toml|glsl|comp|frag|vert|sh|cmake|json))`)");
    static const std::regex kOthers("cuda_gl_interop.h|.*(NAME|SCENE).*");
    std::set<std::string> endings;
    for (auto entry = fs::recursive_directory_iterator(kRoot); entry != fs::recursive_directory_iterator();
         ++entry) {
        const fs::path file = fs::relative(entry->path(), kRoot);
        if (file == "build" || file == ".git") {
            entry.disable_recursion_pending();
            continue;
        }
        std::string ending;
        for (fs::path rest = file; !rest.empty(); rest = rest.parent_path()) {
            ending = rest.filename().string() + (ending.empty() ? "" : "/" + ending);
            endings.insert(ending);
        }
    }
    size_t count = 0;
    for (const fs::path& file : filesWithReferences()) {
        if (!isPage(file)) continue;
        const std::string text = contentOf(file);
        for (auto it = std::sregex_iterator(text.begin(), text.end(), kName); it != std::sregex_iterator();
             ++it) {
            const std::string name = (*it)[1];
            EXPECT_TRUE(endings.count(name) || std::regex_match(name, kOthers))
                << fs::relative(file, kRoot) << " speaks of " << name;
            ++count;
        }
    }
    EXPECT_GT(count, 60u);
}

TEST(References, LinksLeadToFilesAndAnchorsOfTheRepository) {
    static const std::regex kLink(R"(\]\(([^)#\s]*)(#([^)\s]*))?\))");
    size_t count = 0;
    for (const fs::path& file : filesWithReferences()) {
        if (!isPage(file)) continue;
        const std::string text = withoutCode(contentOf(file));
        for (auto it = std::sregex_iterator(text.begin(), text.end(), kLink); it != std::sregex_iterator();
             ++it) {
            const std::string target = (*it)[1], anchor = (*it)[3];
            if (target.rfind("http", 0) == 0) continue;
            const fs::path to = target.empty() ? file : (file.parent_path() / target).lexically_normal();
            EXPECT_TRUE(fs::exists(to)) << file << " links to " << target;
            EXPECT_NE(fs::relative(to, kRoot).string().rfind("..", 0), 0u)
                << file << " links out of the repository: " << target;
            if (!anchor.empty() && fs::exists(to)) {
                EXPECT_TRUE(anchorsOf(to).count(anchor)) << file << " links to " << target << "#" << anchor;
            }
            ++count;
        }
    }
    EXPECT_GT(count, 20u);
}

TEST(Readmes, AreShort) {
    for (const fs::path& file : filesWithReferences()) {
        if (file.filename() != "README.md") continue;
        const std::string text = contentOf(file);
        std::istringstream in(text);
        size_t words = 0;
        for (std::string word; in >> word;) ++words;
        const auto lines = size_t(std::count(text.begin(), text.end(), '\n'));
        EXPECT_LE(lines, kReadmeLines) << fs::relative(file, kRoot);
        EXPECT_LE(words, kReadmeWords) << fs::relative(file, kRoot);
    }
}

}  // namespace
