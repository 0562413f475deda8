// SPDX-License-Identifier: Apache-2.0
// The page of sim_cuda/README.md that maps the paper's equations to functions and tests speaks of functions
// and tests that exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {
namespace fs = std::filesystem;
const fs::path kRoot = DEMOLISH_SOURCE_DIR;

std::string contentOf(const fs::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// All files of a folder and of those below, one after the other.
std::string allUnder(const std::vector<std::string>& folders, const std::string& extension) {
    std::string text;
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
            if (entry.path().extension() == extension) text += contentOf(entry.path());
    return text;
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
    const std::string page_ = contentOf(kRoot / "sim_cuda/README.md");
    const std::vector<Row> rows_ = rowsOf(page_);
    const std::string headers_ = allUnder({"sim_cuda/physics", "sim_cuda/kernels"}, ".h");
    const std::string tests_ = allUnder({"tests/physics", "tests/unit"}, ".cpp");

    bool isFunction(const std::string& name) const {
        return std::regex_search(headers_, std::regex("\\b" + escaped(name) + "\\s*\\("));
    }
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

TEST_F(EquationMap, NamesFunctionsThatExist) {
    std::set<std::string> seen;
    for (const Row& row : rows_) {
        const auto names = inBackquotes(row.functions);
        EXPECT_TRUE(!names.empty() || row.functions == " the same ") << row.equation;
        for (const std::string& name : names) {
            const bool header = name.size() > 2 && name.substr(name.size() - 2) == ".h";
            EXPECT_TRUE(header ? isHeader(name) : isFunction(name)) << row.equation << name;
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
    EXPECT_FALSE(isFunction("hertzForces"));
    EXPECT_TRUE(isFunction("hertzForce"));
    EXPECT_FALSE(isTest("HertzContact", "IsNotThere"));
    EXPECT_TRUE(isTest("HertzContact", "*"));
    EXPECT_FALSE(isTest("NoSuite", "*"));
    EXPECT_FALSE(isTestFile("no_test"));
    EXPECT_FALSE(isHeader("no_laws.h"));
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
