// SPDX-License-Identifier: Apache-2.0
// Every model file of the packages assimp-testmodels, glmark2-data and qt3d5-examples, as far as installed:
// checked at 400 and at 2,000 particles and held to the stored table. DEMOLISH_UPDATE_CORPUS=1 writes the
// table anew and prints times.
#include <gtest/gtest.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

namespace fs = std::filesystem;

const char* const kFolders[] = {"/usr/share/assimp/models", "/usr/share/glmark2/models",
                                "/usr/lib/x86_64-linux-gnu/qt5/examples/qt3d"};
const fs::path kTable = fs::path(DEMOLISH_SOURCE_DIR) / "tests/unit/reading/corpus.csv";

/// Pictures, texts, and what belongs to a model beside its file.
bool isNoModel(const fs::path& file) {
    static const std::vector<std::string> kEndings = {
        ".txt", ".png",  ".jpg",     ".jpeg",   ".mtl", ".bmp",  ".tga",       ".md",   ".html",
        ".bin", ".dds",  ".gif",     ".url",    ".zip", ".pdf",  ".frag",      ".vert", ".glsl",
        ".cpp", ".h",    ".license", ".source", ".qml", ".pro",  ".qrc",       ".csv",  ".svg",
        ".ico", ".webp", ".hdr",     ".js",     ".qbs", ".conf", ".qmlproject"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

std::vector<fs::path> corpus() {
    std::vector<fs::path> files;
    for (const char* folder : kFolders) {
        std::error_code none;
        for (const auto& entry : fs::recursive_directory_iterator(folder, none))
            if (entry.is_regular_file() && !isNoModel(entry.path())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

struct Outcome {
    std::string word;  ///< "as it is", "repaired", "open cells", "refused", "unreadable"
    bool is_model = false;
    double seconds = 0;  ///< of the slower check, the program's start included
};

Outcome checkedAt(const fs::path& file, const std::string& particles, const fs::path& json_file) {
    const auto begun = std::chrono::steady_clock::now();
    const ProgramRun run =
        runProgram({"check", file.string(), "--particles", particles, "--json", json_file.string()});
    Outcome outcome;
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 3) << file << ": " << run.exit_code << ' ' << run.err;
    std::ifstream text(json_file);
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded()) return {"no answer", true, outcome.seconds};
    outcome.is_model = json["triangles"].get<size_t>() >= 4;
    const bool is_read = json["size_in_file"] != nlohmann::json::array({0, 0, 0});
    outcome.word = !json["breaks"].get<bool>()            ? (is_read ? "refused" : "unreadable")
                   : json["open_cells"].get<size_t>() > 0 ? "open cells"
                   : json["repair"].empty()               ? "as it is"
                                                          : "repaired";
    outcome.is_model = outcome.is_model || outcome.word == "refused";
    return outcome;
}

Outcome checked(const fs::path& file, const fs::path& json_file) {
    const Outcome coarse = checkedAt(file, "400", json_file), fine = checkedAt(file, "2000", json_file);
    const bool is_worse = fine.word != "as it is" && fine.word != "repaired";
    Outcome outcome = is_worse ? fine : coarse;
    outcome.seconds = std::max(coarse.seconds, fine.seconds);
    return outcome;
}

std::map<std::string, std::string> storedTable() {
    std::map<std::string, std::string> table;
    std::ifstream in(kTable);
    for (std::string line; std::getline(in, line);)
        if (const size_t comma = line.rfind(','); comma != std::string::npos && line[0] != '#')
            table[line.substr(0, comma)] = line.substr(comma + 1);
    return table;
}

void tellTimes(const std::vector<Outcome>& outcomes) {
    std::vector<double> seconds;
    size_t breaking = 0;
    for (const Outcome& outcome : outcomes) {
        if (!outcome.is_model) continue;
        seconds.push_back(outcome.seconds);
        breaking += outcome.word == "as it is" || outcome.word == "repaired";
    }
    std::sort(seconds.begin(), seconds.end());
    std::printf("%zu files, %zu models, %zu break; seconds: median %.2f, 90 %% within %.2f, worst %.2f\n",
                outcomes.size(), seconds.size(), breaking, seconds[seconds.size() / 2],
                seconds[seconds.size() * 9 / 10], seconds.back());
}

TEST(Corpus, AllButAFewModelsBreak) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const std::vector<fs::path> files = corpus();
    if (files.empty()) GTEST_SKIP() << "none of the packages is installed";
    const TemporaryFolder folder;
    std::vector<Outcome> outcomes(files.size());
    tbb::parallel_for(size_t(0), files.size(), [&](size_t i) {
        outcomes[i] = checked(files[i], folder.path() / (std::to_string(i) + ".json"));
    });
    tellTimes(outcomes);
    size_t models = 0, breaking = 0;
    for (const Outcome& outcome : outcomes) {
        models += outcome.is_model;
        breaking += outcome.is_model && (outcome.word == "as it is" || outcome.word == "repaired");
    }
    EXPECT_GE(double(breaking), 0.99 * double(models));

    if (std::getenv("DEMOLISH_UPDATE_CORPUS") != nullptr) {
        std::ofstream out(kTable);
        out << "# outcome by file, at 400 and at 2,000 particles; assimp 5.2.5 of Debian 12\n";
        for (size_t i = 0; i < files.size(); ++i) out << files[i].string() << ',' << outcomes[i].word << '\n';
        return;
    }
    const auto table = storedTable();
    for (size_t i = 0; i < files.size(); ++i) {
        const auto row = table.find(files[i].string());
        if (row != table.end()) {
            EXPECT_EQ(outcomes[i].word, row->second) << files[i];
        }
    }
}

}  // namespace
}  // namespace demolish::test
