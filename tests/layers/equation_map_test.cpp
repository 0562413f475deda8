// SPDX-License-Identifier: Apache-2.0
// The page that maps the paper's equations to functions and tests speaks of functions that run in the solver
// and of tests that exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {
namespace fs = std::filesystem;
const fs::path kRoot = DEMOLISH_SOURCE_DIR;
/// Holds both tables.
constexpr const char* kPage = "docs/equations.md";
/// Forms of the paper that no solver computes.
constexpr const char* kComparisons = "sim_cuda/physics/paper_forms.h";

std::string contentOf(const fs::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// All files of a folder and of those below, one after the other.
std::string allUnder(const std::vector<std::string>& folders, const std::set<std::string>& extensions) {
    std::string text;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
            if (extensions.count(entry.path().extension()) > 0) text += contentOf(entry.path());
    return text;
}

/// Code alone, with what `namespace` opens taken off, so that a definition stands at depth 0.
std::string withoutComments(const std::string& text) {
    static const std::regex kComment("//[^\n]*"), kNamespace(R"(\bnamespace\s+[\w:]*\s*\{)"),
        kPreprocessor("#[^\n]*");
    const std::string code = std::regex_replace(std::regex_replace(text, kComment, ""), kPreprocessor, "");
    return std::regex_replace(code, kNamespace, ";");
}

/// Functions by name, with their bodies; those of overloads one after the other. `code`: withoutComments().
std::map<std::string, std::string> functionsOf(const std::string& code) {
    static const std::regex kName(R"(\b([a-z]\w*)\s*\()");
    std::map<std::string, std::string> bodies;
    size_t begin = 0, open = 0;
    int depth = 0;
    for (size_t k = 0; k < code.size(); ++k) {
        const char c = code[k];
        if (c == '{' && depth++ == 0) open = k;
        if (c == '}' && depth > 0 && --depth == 0) {
            const std::string head = code.substr(begin, open - begin);
            std::smatch name;
            if (std::regex_search(head, name, kName)) bodies[name[1]] += code.substr(open, k - open);
        }
        if (depth == 0 && (c == ';' || c == '}')) begin = k + 1;
    }
    return bodies;
}

/// Names of what `code` calls; members of anything are no laws.
std::set<std::string> callsOf(const std::string& code) {
    static const std::regex kCall(R"((^|[^\w.>])([a-z]\w*)\s*(<[\w:<>, ]*>)?\s*(?=\())");
    std::set<std::string> names;
    for (auto it = std::sregex_iterator(code.begin(), code.end(), kCall); it != std::sregex_iterator(); ++it)
        names.insert((*it)[2]);
    return names;
}

/// Those of `functions` that `users` call, or that one of those calls.
std::set<std::string> calledFrom(const std::string& users,
                                 const std::map<std::string, std::string>& functions) {
    std::set<std::string> running, next = callsOf(users);
    while (!next.empty()) {
        std::set<std::string> found;
        for (const std::string& name : next) {
            const auto function = functions.find(name);
            if (function == functions.end() || !running.insert(name).second) continue;
            found.merge(callsOf(function->second));
        }
        next = found;
    }
    return running;
}

std::string escaped(const std::string& text) {
    return std::regex_replace(text, std::regex(R"([.*+?^${}()|[\]\\])"), R"(\$&)");
}

/// What stands between backquotes, in order.
std::vector<std::string> inBackquotes(const std::string& cell) {
    static const std::regex kQuoted("`([^`]+)`");
    std::vector<std::string> names;
    for (auto it = std::sregex_iterator(cell.begin(), cell.end(), kQuoted); it != std::sregex_iterator();
         ++it)
        names.push_back((*it)[1]);
    return names;
}

struct Row {
    std::string equation, functions, tests;
};

std::vector<Row> rowsOf(const std::string& page) {
    std::vector<Row> rows;
    std::istringstream in(page.substr(page.find("## The paper's equations")));
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("| (", 0) != 0) continue;
        line = std::regex_replace(line, std::regex(R"(\\\|)"), "!");  // |T| within a cell
        std::vector<std::string> cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, '|');) cells.push_back(cell);
        EXPECT_EQ(cells.size(), 6u) << line;
        if (cells.size() == 6) rows.push_back({cells[1], cells[3], cells[5]});
    }
    return rows;
}

class EquationMap : public testing::Test {
  protected:
    const std::string page_ = contentOf(kRoot / kPage);
    const std::vector<Row> rows_ = rowsOf(page_);
    const std::map<std::string, std::string> laws_ =
        functionsOf(withoutComments(allUnder({"sim_cuda/physics"}, {".h"})));
    /// Laws that a substep, a contact step or the set-up of a scene computes.
    const std::set<std::string> running_ =
        calledFrom(withoutComments(allUnder(
                       {"sim_cuda/kernels", "sim_cuda/patterns", "sim_cuda/solver", "sim_cuda/authoring"},
                       {".h", ".cpp", ".cuh", ".cu"})),
                   laws_);
    const std::string tests_ = allUnder({"tests/physics", "tests/unit"}, {".cpp"});

    /// "Suite.Name", "Suite.*", or "Name" of the suite named before it.
    bool isTest(const std::string& suite, const std::string& name) const {
        const std::string which = name == "*" ? "\\w+" : escaped(name);
        return std::regex_search(tests_, std::regex("TEST(_F|_P)?\\(" + suite + ",\\s*" + which + "\\)"));
    }
    static bool isTestFile(const std::string& name) {
        for (const char* folder : {"tests/physics/laws", "tests/physics", "."})
            if (fs::exists(kRoot / folder / (name + ".cpp"))) return true;
        return false;
    }
    static bool isHeader(const std::string& name) {
        for (const char* folder : {"sim_cuda/physics", "sim_cuda", "."})
            if (fs::exists(kRoot / folder / name)) return true;
        return false;
    }
};

TEST_F(EquationMap, HasEveryEquationOnceInOrder) {
    ASSERT_EQ(rows_.size(), 18u);
    for (size_t k = 0; k < rows_.size(); ++k)
        EXPECT_EQ(rows_[k].equation, " (" + std::to_string(k + 1) + ") ");
}

TEST_F(EquationMap, NamesLawsThatRun) {
    std::set<std::string> seen;
    for (const Row& row : rows_) {
        const auto names = inBackquotes(row.functions);
        EXPECT_TRUE(!names.empty() || row.functions == " the same ") << row.equation;
        for (const std::string& name : names) {
            const bool header = name.size() > 2 && name.substr(name.size() - 2) == ".h";
            if (header)
                EXPECT_TRUE(isHeader(name)) << row.equation << name;
            else
                EXPECT_TRUE(running_.count(name))
                    << row.equation << name << (laws_.count(name) ? " does not run" : " is no law");
            seen.insert(name);
        }
    }
    EXPECT_GT(seen.size(), 25u);
}

TEST_F(EquationMap, NamesTestsThatExist) {
    static const std::regex kTest(R"((\w+)\.(\w+|\*))");
    std::set<std::string> seen;
    for (const Row& row : rows_) {
        std::string suite;
        const auto names = inBackquotes(row.tests);
        EXPECT_TRUE(!names.empty() || row.tests == " the same ") << row.equation;
        for (const std::string& name : names) {
            std::smatch parts;
            if (std::regex_match(name, parts, kTest)) {
                suite = parts[1];
                EXPECT_TRUE(isTest(suite, parts[2])) << row.equation << name;
            } else {
                EXPECT_TRUE(isTestFile(name) || (!suite.empty() && isTest(suite, name)) ||
                            isTestFile("solver/" + name))
                    << row.equation << name;
            }
            seen.insert(name);
        }
    }
    EXPECT_GT(seen.size(), 25u);
}

TEST_F(EquationMap, NoticesNamesThatDoNotExist) {
    EXPECT_FALSE(running_.count("hertzForces"));
    EXPECT_TRUE(running_.count("hertzForce"));
    EXPECT_FALSE(isTest("HertzContact", "IsNotThere"));
    EXPECT_TRUE(isTest("HertzContact", "*"));
    EXPECT_FALSE(isTest("NoSuite", "*"));
    EXPECT_FALSE(isTestFile("no_test"));
    EXPECT_FALSE(isHeader("no_laws.h"));
}

/// What is kept for comparison alone stands in one file; whatever else is in `physics` is computed.
TEST_F(EquationMap, EveryLawRuns) {
    const auto compared = functionsOf(withoutComments(contentOf(kRoot / kComparisons)));
    EXPECT_GT(compared.size(), 3u);
    EXPECT_GT(laws_.size(), 100u);
    for (const auto& [name, body] : laws_)
        EXPECT_TRUE(running_.count(name) || compared.count(name)) << name << " does not run";
}

TEST_F(EquationMap, NoticesLawsThatNobodyRuns) {
    const auto laws = functionsOf(withoutComments(
        "namespace demolish {\n"
        "template <class T>\nDEM_FN T used(T x) {\n    return inner<T>(x) + T{};\n}\n"
        "inline double inner(double x) { return x; }  // as unused() does\n"
        "struct Constants {\n    double k{};\n};\n"
        "inline double unused(Constants c) {\n    if (c.k > 0) { return used(c.k); }\n    return 0;\n}\n"
        "}  // namespace demolish\n"));
    EXPECT_EQ(laws.size(), 3u);
    const std::set<std::string> running = calledFrom("sum += used(1.0);", laws);
    EXPECT_EQ(running, (std::set<std::string>{"used", "inner"}));
}

/// The table of what is tested, below: every program it names is there.
TEST_F(EquationMap, TheTableOfTestsNamesFilesThatExist) {
    std::istringstream in(page_.substr(page_.find("## The physics, tested")));
    size_t files = 0;
    for (std::string line; std::getline(in, line);)
        for (const std::string& name : inBackquotes(line)) {
            if (line.rfind("| ", 0) != 0) continue;
            EXPECT_TRUE(isTestFile(name) || fs::is_directory(kRoot / name)) << name;
            ++files;
        }
    EXPECT_GT(files, 15u);
}

}  // namespace
