// SPDX-License-Identifier: Apache-2.0
// fuzz_files: damaged files of every format, each read by the program as a user has it read. The program must
// end with one of the codes of a file that it takes or refuses, and say why in one sentence.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/fuzz/files/file_formats.h"
#include "tests/fuzz/files/mutation.h"
#include "tests/fuzz/support/child_program.h"
#include "tests/unit/app/run_program.h"

namespace demolish::fuzz {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr int kSkipped = 77;

struct Options {
    uint64_t seed = 1;
    size_t count = 100;
    std::vector<std::string> formats;
    std::optional<uint64_t> only;
    double seconds = 60;  ///< of processor time that one file may take
    fs::path keep = fs::temp_directory_path() / "demolish_fuzz_files";
};

/// Exit 5 among them where a file may say anything that is in range, so that something flies apart.
bool isAllowed(const ChildEnd& end, const FileFormat& format) {
    for (const int code : {0, 2, 3})
        if (end.endedWith(code)) return true;
    return format.may_fly_apart && end.endedWith(5);
}

bool isPlainText(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\r' || c == '\t' || c == '\x1b';
    });
}

/// What is wrong with the end of a run, "" if nothing is.
std::string fault(const ChildEnd& end, const FileFormat& format) {
    if (!isAllowed(end, format)) return describe(end);
    if (!isPlainText(end.err)) return "what it says has control characters";
    if (end.exit_code == 0) return "";
    const size_t last = end.err.rfind("demolish: ");
    if (last == std::string::npos) return describe(end) + " without a sentence";
    const std::string sentence = end.err.substr(last);
    if (std::count(sentence.begin(), sentence.end(), '\n') != 1) return "more than one line for one fault";
    constexpr size_t kLongest = 1100;
    return sentence.size() > kLongest ? "a sentence of " + std::to_string(sentence.size()) + " letters" : "";
}

/// Another sequence for each format, the same on every machine.
uint64_t seedOf(const std::string& format, uint64_t seed) {
    for (const char c : format) seed = seed * 31 + static_cast<unsigned char>(c);
    return seed;
}

class Fuzzer {
  public:
    explicit Fuzzer(Options options)
        : options_(std::move(options)),
          scratch_(fs::temp_directory_path() / ("demolish_fuzz_" + std::to_string(getpid()))) {}
    ~Fuzzer() {
        std::error_code ignored;
        fs::remove_all(scratch_, ignored);
    }
    Fuzzer(const Fuzzer&) = delete;
    Fuzzer& operator=(const Fuzzer&) = delete;

    int run() {
        for (const FileFormat& format : fileFormats(scratch_ / "made")) {
            const auto& wanted = options_.formats;
            if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), format.name) == wanted.end())
                continue;
            readWholeFiles(format);
            const uint64_t first = options_.only.value_or(0),
                           end = options_.only ? first + 1 : options_.count;
            for (uint64_t index = first; index < end; ++index) readDamaged(format, index);
            std::printf("%s\n", Json{{"format", format.name}, {"exits", exits_[format.name]}}.dump().c_str());
            std::fflush(stdout);
        }
        std::printf("%s\n", Json{{"files", files_}, {"findings", findings_}}.dump().c_str());
        return findings_ > 0 ? 1 : 0;
    }

  private:
    ChildEnd read(const FileFormat& format, const std::string& bytes, ReadingCommand& command) {
        const fs::path folder = scratch_ / "file";
        fs::remove_all(folder);
        fs::create_directories(folder);
        command = format.place(bytes, folder);
        command.words.insert(command.words.begin(), test::programPath());
        ++files_;
        const ChildEnd end =
            runChild(command.words, {.seconds = 10 * options_.seconds, .cpu_seconds = options_.seconds},
                     command.environment);
        ++exits_[format.name][describe(end)];
        return end;
    }
    /// Or else nothing would be tried but the refusal.
    void readWholeFiles(const FileFormat& format) {
        for (const std::string& seed : format.seeds) {
            ReadingCommand command;
            const ChildEnd end = read(format, seed, command);
            if (!end.endedWith(0)) report(format, "whole", end, "a whole file was refused", command);
        }
    }
    void readDamaged(const FileFormat& format, uint64_t index) {
        Dice dice(seedOf(format.name, options_.seed), index);
        const std::string bytes = mutated(dice.pick(format.seeds), dice);
        ReadingCommand command;
        const ChildEnd end = read(format, bytes, command);
        const std::string wrong = fault(end, format);
        if (!wrong.empty()) report(format, std::to_string(index), end, wrong, command);
    }
    /// The file stays where the command that shows the finding can read it.
    void report(const FileFormat& format, const std::string& index, const ChildEnd& end,
                const std::string& wrong, const ReadingCommand& command) {
        ++findings_;
        const fs::path kept =
            options_.keep / (format.name + "_" + std::to_string(options_.seed) + "_" + index);
        fs::remove_all(kept);
        fs::create_directories(options_.keep);
        fs::copy(scratch_ / "file", kept, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
        std::string line = commandLine(command.environment) + " " + commandLine(command.words);
        const std::string scratch = (scratch_ / "file").string();
        for (size_t at = 0; (at = line.find(scratch)) != std::string::npos;)
            line.replace(at, scratch.size(), kept.string());
        const Json json{{"finding", wrong},
                        {"format", format.name},
                        {"index", index},
                        {"command", line},
                        {"stderr", end.err.substr(end.err.size() > 800 ? end.err.size() - 800 : 0)}};
        std::printf("%s\n", json.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
        std::fflush(stdout);
    }

    Options options_;
    fs::path scratch_;
    std::map<std::string, std::map<std::string, size_t>> exits_;
    size_t files_ = 0, findings_ = 0;
};

int parseAndRun(int argument_count, char** arguments) {
    Options options;
    CLI::App app{"Damaged files of every format, each read by the program.", "fuzz_files"};
    app.add_option("--seed", options.seed, "Which files");
    app.add_option("--count", options.count, "Files of each format");
    app.add_option("--format", options.formats, "These alone")->delimiter(',');
    app.add_option("--only", options.only, "This file of the seed alone");
    app.add_option("--limit", options.seconds, "Processor seconds that one file may take");
    app.add_option("--keep", options.keep, "Folder for files that showed something");
    CLI11_PARSE(app, argument_count, arguments);
    if (test::programPath().empty()) {
        std::puts("the program is not built here; set DEMOLISH_PROGRAM: skipped");
        return kSkipped;
    }
    return Fuzzer(options).run();
}

}  // namespace
}  // namespace demolish::fuzz

int main(int argc, char** argv) {
    return demolish::fuzz::parseAndRun(argc, argv);
}
