// SPDX-License-Identifier: Apache-2.0
// Subcommands and exit codes.
#include "app/commands/program.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

#include "app/commands/bench_command.h"
#include "app/commands/breakage_command.h"
#include "app/commands/build_version.h"
#include "app/commands/calibrate_command.h"
#include "app/commands/capture_command.h"
#include "app/commands/check_command.h"
#include "app/commands/help_text.h"
#include "app/commands/info_command.h"
#include "app/commands/interrupt.h"
#include "app/commands/one_sentence.h"
#include "app/commands/scene_command.h"
#include "app/commands/view_command.h"
#include "app/process/child_process.h"
#include "app/reading/model_reader.h"
#include "app/reading/model_service.h"
#include "engine/gl/error.h"
#include "engine/image/png.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

int fail(ExitCode code, const std::string& sentence) {
    std::fprintf(stderr, "demolish: %s\n", oneSentence(sentence).c_str());
    return static_cast<int>(code);
}

/// What libraries say goes to stderr: stdout belongs to the tables and to JSON.
void setUpLog() {
    auto logger = spdlog::stderr_color_mt("demolish");
    logger->set_pattern("%^%n%$: %v");
    spdlog::set_default_logger(logger);
}

/// A line that does not begin with a command is CLI11's "A subcommand is required", whatever it begins with.
std::string complaint(const CLI::App& app, const CLI::ParseError& error, int argument_count,
                      char** arguments) {
    const std::string first = argument_count < 2 ? "" : arguments[1];
    std::string names;
    bool known = first.starts_with('-');
    for (const CLI::App* command : app.get_subcommands({})) {
        names += (names.empty() ? "" : ", ") + command->get_name();
        known = known || command->get_name() == first;
    }
    if (first.empty()) return "give a command: " + names + "; see demolish --help";
    if (!known) return "there is no command '" + first + "'; choose one of: " + names;
    return std::string(error.what()) + "; see demolish --help";
}

/// A value that is empty, as "$SPEED" is where nobody has set it, would mean the default: refused.
void refuseEmptyValues(CLI::App& app) {
    for (CLI::Option* option : app.get_options())
        if (option->get_items_expected_max() > 0)
            option->check(
                [](const std::string& value) {
                    return value.empty() ? std::string("is empty; give a value or leave it out")
                                         : std::string();
                },
                "");
    for (CLI::App* command : app.get_subcommands({})) refuseEmptyValues(*command);
}

int failInside(const char* what) {
    return fail(ExitCode::kNumerical,
                std::string("a fault of the program ended the run (") + what + "); please report it");
}

/// What is being thrown, as one sentence and an exit code, whatever it is.
int tellError() {
    try {
        throw;
    } catch (const Error& error) {
        return fail(error.code(), error.what());
    } catch (const Interrupted& interrupted) {
        std::fprintf(stderr, "demolish: %s\n", interrupted.what());
        std::fflush(nullptr);
        std::_Exit(kInterruptedCode);  // a body may still be in the making: nothing waits for it
    } catch (const engine::gl::GlError& error) {
        return fail(ExitCode::kDevice, error.what());
    } catch (const engine::ImageError& error) {
        return fail(ExitCode::kOutput, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return fail(ExitCode::kOutput, std::string(error.what()) + "; choose another place or make room");
    } catch (const std::system_error& error) {
        return fail(ExitCode::kDevice, std::string("the system refused: ") + error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::kDevice, "memory does not suffice; ask for fewer particles (--particles)");
    } catch (const std::exception& error) {
        return failInside(error.what());
    } catch (...) {
        return failInside("nothing is known of it");
    }
}

int parseAndRun(CLI::App& app, int argument_count, char** arguments) {
    try {
        app.parse(argument_count, arguments);
        return 0;
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::CallForAllHelp& help) {
        return app.exit(help);
    } catch (const CLI::CallForVersion& version) {
        return app.exit(version);
    } catch (const CLI::ConversionError& error) {
        return fail(ExitCode::kUsage,
                    std::string(error.what()) + "; give a plain number, in SI units (m, m/s, s)");
    } catch (const CLI::ParseError& error) {
        return fail(ExitCode::kUsage, complaint(app, error, argument_count, arguments));
    }
}

int run(int argument_count, char** arguments) {
    CLI::App app{"Demolish breaks models: a mesh goes in, an impact breaks it, the pieces fly.", "demolish"};
    app.set_version_flag("--version", std::string("demolish ") + buildVersion());
    app.require_subcommand(1);
    app.formatter(std::make_shared<HelpFormatter>());
    setExamples(app, {"view bunny", "view --model statue.obj --height 2 --impact-velocity 20",
                      "capture bunny --frames 150 --out out/bunny --video out/bunny/bunny.mp4",
                      "bench vase --json vase.json --curve vase.svg", "calibrate bunny --packings 4",
                      "check statue.obj", "breakage --out out/breakage"});
    ViewOptions view;
    CaptureOptions capture;
    BenchOptions bench;
    BreakageOptions breakage;
    CalibrateOptions calibrate;
    CheckOptions check;
    SceneOptions scene;
    ShotOptions info;
    addViewCommand(app, view);
    addCaptureCommand(app, capture);
    addBenchCommand(app, bench);
    addBreakageCommand(app, breakage);
    addCalibrateCommand(app, calibrate);
    addCheckCommand(app, check);
    addSceneCommand(app, scene);
    addInfoCommand(app, info);
    refuseEmptyValues(app);
    return parseAndRun(app, argument_count, arguments);
}

}  // namespace

int runProgram(int argument_count, char** arguments) {
    if (argument_count >= 4 && std::string_view(arguments[1]) == kReadModelCommand)
        serveModel(arguments[2], {arguments + 3, arguments + argument_count});
    if (argument_count == 3 && std::string_view(arguments[1]) == kReadSetCommand) serveSet(arguments[2]);
    try {
        setModelReader(kOwnProgram);
        setUpLog();
        return run(argument_count, arguments);
    } catch (...) {
        return tellError();
    }
}

}  // namespace demolish
