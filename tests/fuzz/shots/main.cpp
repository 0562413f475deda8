// SPDX-License-Identifier: Apache-2.0
// fuzz_shots: random shots for a given time, each in a process of its own, run twice and compared.
// One line of JSON a shot and a finding; the commands in them show a finding again.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_cuda/api/solver.h"
#include "tests/fuzz/shots/findings.h"
#include "tests/fuzz/support/child_program.h"

namespace demolish::fuzz {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
constexpr int kSkipped = 77;

struct Options {
    uint64_t seed = 1;
    double seconds = 120;
    uint64_t shots = ~uint64_t{0};  ///< at most
    std::optional<uint64_t> only;
    std::string device = "cpu";
    double cost = 0;  ///< 0: what suits the device
    bool record = false, sets = false, in_process = false, show = false;
    std::filesystem::path models = std::filesystem::temp_directory_path() / "demolish_fuzz_models";
};

RandomShotLimits limitsOf(const Options& options) {
    RandomShotLimits limits;
    limits.device = options.device;
    limits.may_record = options.record;
    limits.sets = options.sets;
    limits.cost = options.cost > 0 ? options.cost : options.device == "cuda" ? 3e7 : 3e6;
    return limits;
}

/// The words that show shot `index` again, in a process of its own or in this one.
std::vector<std::string> ownWords(const Options& options, uint64_t index) {
    std::vector<std::string> words = {"fuzz_shots", "--seed", std::to_string(options.seed), "--only",
                                      std::to_string(index)};
    if (options.device != "cpu") words.insert(words.end(), {"--device", options.device});
    if (options.cost > 0) words.insert(words.end(), {"--cost", std::to_string(options.cost)});
    if (options.record) words.emplace_back("--record");
    if (options.sets) words.emplace_back("--sets");
    words.insert(words.end(), {"--models", options.models.string()});
    return words;
}

void print(const Json& line) {
    // What a program says of itself may be cut within a letter.
    std::puts(line.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

void printFinding(const Options& options, uint64_t index, const RandomShot& random, const Finding& finding) {
    Json line{{"finding", finding.kind},
              {"shot", index},
              {"what", finding.sentence},
              {"command", commandLine(ownWords(options, index))}};
    line[random.isForBench() ? "bench" : "nearly"] = "demolish " + commandLine(random.benchWords());
    print(line);
}

Json summaryOf(uint64_t index, const RandomShot& random, const ShotRun& run) {
    const ShotOptions& options = random.options;
    Json line{
        {"shot", index},
        {"of", options.scene.empty() ? std::filesystem::path(options.model).stem().string() : options.scene},
        {"particles", run.particles},
        {"frames", run.frames},
        {"broken", run.broken},
        {"made_s", run.built_seconds},
        {"seconds", run.seconds},
        {"cost", random.cost},
        {"watched", random.watching.inWords()}};
    if (run.brought_in > 0) line["closure"] = run.closure;
    if (!run.refused.empty()) line["refused"] = run.refused;
    if (!run.stopped.empty()) line["stopped"] = run.stopped;
    return line;
}

/// What a shot is, without running it.
int show(uint64_t index, const RandomShot& random) {
    print({{"shot", index},
           {"frames", random.frames},
           {"cost", random.cost},
           {random.isForBench() ? "bench" : "nearly", "demolish " + commandLine(random.benchWords())}});
    return 0;
}

/// Both runs here; a crash ends this process.
int runHere(const Options& options, uint64_t index, const RandomShot& random) {
    const ShotRun alone = runShot(random, {}), watched = runShot(random, random.watching);
    print(summaryOf(index, random, watched));
    for (const Finding& finding : findingsOf(alone, watched)) printFinding(options, index, random, finding);
    return 0;
}

/// Time that nothing excuses: making, and a rate that the slowest processor beats; ten times as long where
/// other work takes its turns. What a strength for a velocity (--break-at) costs nobody knows before the body
/// is made: a thin plate of glass on its edge has 24,000 substeps a frame where 78 were expected.
ChildLimits limitsOf(const RandomShot& random) {
    const double expected = random.options.break_at ? 10 * random.cost : random.cost;
    const double cpu_seconds = 120 + 2 * expected / 2e4;
    return {.seconds = 10 * cpu_seconds, .cpu_seconds = cpu_seconds};
}

/// Counts what the shots of a run showed.
class Tally {
  public:
    void addShot(const Json& line) {
        ++shots_;
        if (line.contains("refused")) ++refused_;
        if (line.contains("stopped")) ++stopped_;
    }
    void add(const Finding& finding) { ++kinds_[finding.kind]; }
    bool failed() const { return !kinds_.empty(); }
    Json json(double seconds) const {
        return {{"shots", shots_},
                {"seconds", seconds},
                {"refused", refused_},
                {"stopped", stopped_},
                {"findings", kinds_}};
    }

  private:
    uint64_t shots_ = 0, refused_ = 0, stopped_ = 0;
    std::map<std::string, uint64_t> kinds_;
};

void takeLines(const ChildEnd& end, Tally& tally) {
    std::istringstream lines(end.out);
    for (std::string text; std::getline(lines, text);) {
        const Json line = Json::parse(text, nullptr, false);
        if (!line.is_object()) continue;
        print(line);
        if (line.contains("finding"))
            tally.add({line["finding"], ""});
        else
            tally.addShot(line);
    }
}

/// Last line of what a child said, where it says why it ended.
std::string lastLine(const std::string& text) {
    const size_t end = text.find_last_not_of('\n');
    if (end == std::string::npos) return "";
    const size_t begin = text.find_last_of('\n', end);
    return text.substr(begin == std::string::npos ? 0 : begin + 1, end - begin);
}

void runApart(const Options& options, uint64_t index, Tally& tally) {
    const RandomShot random = randomShot(options.seed, index, limitsOf(options), options.models);
    std::vector<std::string> words = ownWords(options, index);
    words[0] = ownProgram();
    words.emplace_back("--in-process");
    const ChildEnd end = runChild(words, limitsOf(random));
    takeLines(end, tally);
    if (end.endedWith(0)) return;
    const Finding finding{end.timed_out ? "hang" : "crash", describe(end) + ": " + lastLine(end.err)};
    printFinding(options, index, random, finding);
    tally.add(finding);
}

int run(const Options& options) {
    if (options.in_process || options.show) {
        const RandomShot random = randomShot(options.seed, *options.only, limitsOf(options), options.models);
        return options.show ? show(*options.only, random) : runHere(options, *options.only, random);
    }
    if (options.device == "cuda" && !findCudaDevice().usable) {
        std::puts("there is no usable GPU: skipped");
        return kSkipped;
    }
    Tally tally;
    const auto begun = Clock::now();
    const auto elapsed = [begun] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
    if (options.only)
        runApart(options, *options.only, tally);
    else
        for (uint64_t index = 0; index < options.shots && elapsed() < options.seconds; ++index)
            runApart(options, index, tally);
    print(tally.json(elapsed()));
    return tally.failed() ? 1 : 0;
}

int parseAndRun(int argument_count, char** arguments) {
    Options options;
    CLI::App app{"Random shots, each in a process of its own, run twice and compared.", "fuzz_shots"};
    app.add_option("--seed", options.seed, "Which shots");
    app.add_option("--seconds", options.seconds, "How long; a shot that has begun is finished");
    app.add_option("--shots", options.shots, "At most so many");
    app.add_option("--device", options.device)->check(CLI::IsMember({"cpu", "cuda"}));
    app.add_option("--only", options.only, "This shot of the seed alone");
    app.add_option("--cost", options.cost, "Particles x substeps of a run, about");
    app.add_flag("--sets", options.sets, "Scenes of several bodies");
    app.add_option("--models", options.models, "Folder for the models and scenes that are made");
    app.add_flag("--record", options.record, "Some shots are recorded; needs OpenGL");
    app.add_flag("--in-process", options.in_process, "With --only: no process of its own, for a debugger");
    app.add_flag("--show", options.show, "With --only: say what the shot is, and run nothing");
    CLI11_PARSE(app, argument_count, arguments);
    if (!options.only && (options.in_process || options.show)) options.only = 0;
    return run(options);
}

}  // namespace
}  // namespace demolish::fuzz

int main(int argc, char** argv) {
    return demolish::fuzz::parseAndRun(argc, argv);
}
