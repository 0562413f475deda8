// SPDX-License-Identifier: Apache-2.0
// fuzz_soak: the window in use for a given time (rebuilds, shots by hand, scrubbing, reset, other models),
// and its memory and open files looked at after every round. Neither may grow once everything has been used.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <ios>
#include <iterator>
#include <sstream>
#include <thread>

#include "tests/fuzz/soak/trend.h"
#include "tests/fuzz/support/child_program.h"
#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::fuzz {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
constexpr int kSkipped = 77;

struct Options {
    double seconds = 1800;
    std::string device = "cpu";
    bool own_display = false;
};

/// One round; the next one begins where it ends.
std::string roundOf(size_t number, const fs::path& folder) {
    static const std::vector<std::string> kModels = {"block.obj", "vase_paper.obj"};
    const fs::path model =
        fs::path(DEMOLISH_SOURCE_DIR) / "assets" / "models" / kModels[number % kModels.size()];
    std::ostringstream script;
    script << "wait 2\ntype shot.model " << model.string() << "\nclick shot.load\nwait 2\nuntil rebuilt\n"
           << "set particles.size " << (number % 3 == 0 ? 0.8 : 0.65) << "\nwait 2\nuntil rebuilt\n"
           << "click transport.reset\nkey space\nwait 12\nclick impact.fire\nwait 12\n"
           << "set transport.timeline 0.3\nwait 2\nset transport.timeline 0.9\nkey space\nwait 6\n"
           << "set impact.velocity " << (number % 2 == 0 ? 0.3 : 0.7) << "\nkey r\nwait 6\n"
           << "state " << (folder / ("round_" + std::to_string(number) + ".json")).string() << "\n";
    return script.str();
}

/// A file of /proc; "" where its process has gone.
std::string procText(const fs::path& file) {
    try {
        return test::readText(file);
    } catch (const std::ios_base::failure&) {
        return "";
    }
}

/// The process that runs the program with this script; 0 while there is none.
pid_t processWith(const std::string& script) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator("/proc", error)) {
        const std::string words = procText(entry.path() / "cmdline");
        if (words.find(script) == std::string::npos) continue;
        std::error_code ignored;
        if (fs::equivalent(entry.path() / "exe", test::programPath(), ignored))
            return static_cast<pid_t>(std::stoul(entry.path().filename().string()));
    }
    return 0;
}

/// MiB of a line such as "RssAnon:   123456 kB".
double mebibytes(const std::string& status, const std::string& key) {
    const size_t at = status.find(key + ":");
    return at == std::string::npos ? 0 : std::strtod(status.c_str() + at + key.size() + 1, nullptr) / 1024;
}

/// MiB in use on the GPU that is seen first, 0 without one.
double gpuMebibytes() {
    const ChildEnd end =
        runChild({"nvidia-smi", "--query-gpu=memory.used", "--format=csv,noheader,nounits"}, {.seconds = 20});
    return end.endedWith(0) ? std::strtod(end.out.c_str(), nullptr) : 0;
}

Usage usageOf(pid_t process, bool on_gpu) {
    const fs::path folder = "/proc/" + std::to_string(process);
    std::error_code error;
    const auto files = fs::directory_iterator(folder / "fd", error);
    return {mebibytes(procText(folder / "status"), "VmRSS"), on_gpu ? gpuMebibytes() : 0,
            static_cast<double>(std::distance(begin(files), end(files)))};
}

/// Samples after each round until the window has gone or the time is over.
std::vector<Usage> watch(const fs::path& folder, const std::string& script, const Options& options,
                         const std::atomic<bool>& gone) {
    std::vector<Usage> samples;
    const auto begun = Clock::now();
    while (!gone && std::chrono::duration<double>(Clock::now() - begun).count() < options.seconds) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        if (!fs::exists(folder / ("round_" + std::to_string(samples.size()) + ".json"))) continue;
        const pid_t process = processWith(script);
        if (process == 0) continue;
        samples.push_back(usageOf(process, options.device == "cuda"));
        const Usage& last = samples.back();
        std::printf("{\"round\":%zu,\"resident_mib\":%.1f,\"gpu_mib\":%.0f,\"files\":%.0f}\n", samples.size(),
                    last.resident, last.gpu, last.files);
        std::fflush(stdout);
    }
    return samples;
}

int judge(const std::vector<Usage>& samples) {
    const std::vector<std::string> faults = growth(samples);
    for (const auto& fault : faults) std::printf("{\"finding\":\"%s\"}\n", fault.c_str());
    std::printf("{\"rounds\":%zu,\"findings\":%zu}\n", samples.size(), faults.size());
    return faults.empty() ? 0 : 1;
}

int run(const Options& options) {
    if (test::programPath().empty() ||
        (!options.own_display && std::system("command -v xvfb-run >/dev/null") != 0)) {
        std::puts("no program or no xvfb-run here: skipped");
        return kSkipped;
    }
    const test::TemporaryFolder folder;
    std::string script;
    const auto rounds = static_cast<size_t>(options.seconds) + 10;  // a round takes longer than a second
    for (size_t k = 0; k < rounds; ++k) script += roundOf(k, folder.path());
    const std::string file = folder.write("soak.txt", script);
    std::vector<std::string> words = {"xvfb-run", "-a", "-s", "-screen 0 1280x800x24"};
    if (options.own_display) words.clear();
    words.insert(words.end(),
                 {test::programPath(), "view", "block", "--particles", "300", "--device", options.device,
                  "--size", "900x640", "--quality", "draft", "--no-vsync", "--script", file});
    std::vector<std::string> environment = {"XDG_CACHE_HOME=" + folder.path().string()};
    if (!options.own_display) environment.emplace_back("LIBGL_ALWAYS_SOFTWARE=1");
    std::atomic<bool> gone = false;
    ChildEnd end;
    std::thread window([&] {
        end = runChild(words, {.seconds = options.seconds + 5}, environment);
        gone = true;
    });
    const std::vector<Usage> samples = watch(folder.path(), file, options, gone);
    window.join();
    if (!end.timed_out) {
        std::printf("the window ended by itself: %s\n%s\n", describe(end).c_str(), end.err.c_str());
        return 1;
    }
    return judge(samples);
}

int parseAndRun(int argument_count, char** arguments) {
    Options options;
    CLI::App app{"The window in use for hours; its memory and open files must not grow.", "fuzz_soak"};
    app.add_option("--seconds", options.seconds, "How long")->check(CLI::Range(60.0, 1e6));
    app.add_option("--device", options.device)->check(CLI::IsMember({"cpu", "cuda"}));
    app.add_flag("--own-display", options.own_display, "On the display that there is, not under Xvfb");
    CLI11_PARSE(app, argument_count, arguments);
    return run(options);
}

}  // namespace
}  // namespace demolish::fuzz

int main(int argc, char** argv) {
    return demolish::fuzz::parseAndRun(argc, argv);
}
