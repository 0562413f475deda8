// SPDX-License-Identifier: Apache-2.0
// Plan, items that are missing, gathering.
#include "app/commands/breakage_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "app/breakage/item_file.h"
#include "app/breakage/jobs.h"
#include "app/breakage/report.h"
#include "app/commands/help_text.h"
#include "app/commands/progress_bar.h"
#include "app/session/built_shot.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

// What a CPU does when nobody asks for more: enough to see that specimens hold below and break above.
constexpr uint32_t kReducedPackings = 3, kReducedVelocities = 3;
constexpr Range kCountRange{1, 1000}, kBatchRange{1, 100000}, kJobRange{1, 64};

uint32_t wholeNumber(const char* option, double value, const Range& range) {
    requireInRange(option, value, range, "");
    if (value != std::floor(value)) throw UsageError(std::string(option) + " must be a whole number");
    return static_cast<uint32_t>(value);
}

bool choosesGpu(const BreakageOptions& options) {
    Shot shot;
    shot.device = options.device == "cpu"    ? DeviceChoice::kCpu
                  : options.device == "cuda" ? DeviceChoice::kCuda
                                             : DeviceChoice::kAuto;
    return choosesCuda(shot);
}

/// All readings on a GPU, the first one with few specimens on a CPU, unless the options say otherwise.
BreakagePlan makePlan(const BreakageOptions& options, bool reduced) {
    BreakagePlan plan;
    std::vector<std::string> names = options.experiments;
    if (names.empty()) {
        names = experimentNames();
        if (reduced) names.resize(1);
    }
    for (const std::string& name : names) plan.experiments.push_back(findExperiment(name));
    for (BreakageExperiment& experiment : plan.experiments) {
        if (reduced) {
            experiment.packings = std::min(experiment.packings, kReducedPackings);
            experiment.velocities = std::min(experiment.velocities, kReducedVelocities);
        }
        if (options.packings) experiment.packings = wholeNumber("--packings", *options.packings, kCountRange);
        if (options.velocities)
            experiment.velocities = wholeNumber("--velocities", *options.velocities, {1, 200});
    }
    if (options.batch) plan.batch = wholeNumber("--batch", *options.batch, kBatchRange);
    return plan;
}

/// Does nothing when the item is there already.
void computeItem(const BreakagePlan& plan, const BreakageOptions& options, size_t item, bool on_gpu) {
    const auto runs = plan.items()[item];
    if (readItem(options.out, plan, item, runs)) return;
    ProgressBar bar;
    const std::string of = " " + std::to_string(item + 1) + "/" + std::to_string(plan.items().size());
    const ItemResult result = runItem(plan, runs, on_gpu, [&](double fraction, const char* stage) {
        if (!options.quiet) bar.show(fraction, stage + of);
        return true;
    });
    writeItem(options.out, plan, item, runs, result);
}

std::vector<size_t> missingItems(const BreakagePlan& plan, const BreakageOptions& options) {
    const auto items = plan.items();
    std::vector<size_t> missing;
    for (size_t item = 0; item < items.size(); ++item)
        if (!readItem(options.out, plan, item, items[item])) missing.push_back(item);
    return missing;
}

/// The arguments that make another process compute one item of the same plan.
std::vector<std::string> argumentsFor(const BreakageOptions& options, size_t item, bool on_gpu) {
    std::vector<std::string> words{"breakage"};
    words.insert(words.end(), options.experiments.begin(), options.experiments.end());
    const auto add = [&](const char* name, const std::string& value) {
        words.push_back(std::string(name) + "=" + value);  // in one word, since a folder may begin with '-'
    };
    const auto addNumber = [&](const char* name, const std::optional<double>& value) {
        if (value) add(name, std::to_string(static_cast<uint64_t>(*value)));
    };
    add("--out", options.out);
    add("--device", on_gpu ? "cuda" : "cpu");
    addNumber("--packings", options.packings);
    addNumber("--velocities", options.velocities);
    addNumber("--batch", options.batch);
    if (options.full) words.emplace_back("--full");
    words.emplace_back("--quiet");
    add("--index", std::to_string(item));
    return words;
}

void runMissing(const BreakagePlan& plan, const BreakageOptions& options, bool on_gpu) {
    const auto missing = missingItems(plan, options);
    const size_t jobs = wholeNumber("--jobs", options.jobs, kJobRange);
    if (jobs == 1) {
        for (const size_t item : missing) computeItem(plan, options, item, on_gpu);
        return;
    }
    if (on_gpu) checkGpus(jobs, static_cast<size_t>(findCudaDevice().count));
    std::vector<std::vector<std::string>> arguments;
    for (const size_t item : missing) arguments.push_back(argumentsFor(options, item, on_gpu));
    ProgressBar bar;
    runJobs(arguments, jobs, on_gpu, [&](size_t done) {
        if (!options.quiet)
            bar.show(static_cast<double>(done) / static_cast<double>(missing.size()), "items");
    });
}

void gather(const BreakagePlan& plan, const std::string& out) {
    const GatheredResults gathered = gatherResults(plan, out);
    std::fputs(gathered.table.c_str(), stdout);
    std::printf(
        "written to %s: figure_1, figure_2a, figure_2b (.svg%s), probability.csv, specimens.csv, "
        "breakage.json\n",
        out.c_str(), gathered.has_png ? ", .png" : "");
    if (!gathered.has_png)
        std::fputs(
            "no PNG: the rsvg-convert program is missing; install the package librsvg2-bin, then "
            "demolish breakage gather\n",
            stderr);
}

void runBreakage(const BreakageOptions& options) {
    const bool on_gpu = choosesGpu(options);
    const bool reduced = !on_gpu && !options.full;
    const BreakagePlan plan = makePlan(options, reduced);
    const size_t items = plan.items().size();
    if (options.count) {
        std::printf("%zu\n", items);
        return;
    }
    if (options.out.empty()) throw UsageError("say where the results go: --out DIR");
    settlePlan(plan, options.out);
    if (options.index) {
        const uint32_t item = wholeNumber("--index", *options.index, {0, static_cast<double>(items - 1)});
        computeItem(plan, options, item, on_gpu);
        return;
    }
    if (reduced && !options.packings && !options.velocities)
        std::fprintf(stderr, "a reduced set, for the CPU: %u packings, %u velocities; --full runs all\n",
                     plan.experiments[0].packings, plan.experiments[0].velocities);
    runMissing(plan, options, on_gpu);
    gather(plan, options.out);
}

void addGather(CLI::App& command, BreakageOptions& options) {
    auto* joined = command.add_subcommand("gather", "Join the items in DIR into tables and figures");
    joined->add_option("--out", options.out, "Folder that the items were written to")
        ->type_name("DIR")
        ->required();
    joined->callback([&options] { gather(readPlan(options.out), options.out); });
}

}  // namespace

void addBreakageCommand(CLI::App& app, BreakageOptions& options) {
    auto* command = app.add_subcommand(
        "breakage", "The paper's breakage experiment: round specimens on a wall (Figs 1, 2)");
    command
        ->add_option("experiments", options.experiments,
                     "Readings: names of assets/experiments or TOML files (default: all; on a CPU the first)")
        ->type_name("NAME");
    command
        ->add_option("--out", options.out, "Folder for results; what is there already is not computed again")
        ->type_name("DIR");
    command->add_option("--device", options.device, "Where to simulate")
        ->type_name("auto|cpu|cuda")
        ->check(CLI::IsMember({"auto", "cpu", "cuda"}).description(""))
        ->capture_default_str();
    command->add_option("--packings", options.packings, "Random packings of each size")->type_name("N");
    command->add_option("--velocities", options.velocities, "Velocities of the sweep, evenly spaced")
        ->type_name("N");
    command->add_flag("--full", options.full, "The whole sweep on a CPU, not the reduced one");
    command->add_option("--batch", options.batch, "Most specimens in one simulation: one item (default: 600)")
        ->type_name("N");
    command->add_option("--jobs", options.jobs, "Processes side by side, one to a GPU")
        ->type_name("N")
        ->capture_default_str();
    command->add_option("--index", options.index, "Compute this item alone, for job arrays; then gather")
        ->type_name("I");
    command->add_flag("--quiet", options.quiet, "No progress bar");
    command->add_flag("--count", options.count, "Print how many items there are, and stop");
    setExamples(*command, {"breakage --out out/breakage", "breakage --count",
                           "breakage --index 3 --out out/breakage", "breakage gather --out out/breakage"});
    addGather(*command, options);
    command->callback([command, &options] {
        if (command->get_subcommands().empty()) runBreakage(options);
    });
}

}  // namespace demolish
