// SPDX-License-Identifier: Apache-2.0
// fork, exec, two files for what it says.
#include "tests/unit/app/run_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

void redirect(int descriptor, const std::filesystem::path& file) {
    const int target = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(target, descriptor);
    close(target);
}

}  // namespace

std::string programPath() {
    if (const char* chosen = std::getenv("DEMOLISH_PROGRAM")) return chosen;
    return std::filesystem::exists(DEMOLISH_PROGRAM) ? DEMOLISH_PROGRAM : "";
}

ProgramRun runProgram(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                      const std::vector<std::string>& prefix) {
    std::vector<std::string> words = prefix;
    words.push_back(programPath());
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (auto& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        redirect(STDOUT_FILENO, folder.path() / "out");
        redirect(STDERR_FILENO, folder.path() / "err");
        for (const auto& setting : environment) {
            const size_t equals = setting.find('=');
            setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
        }
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ProgramRun run;
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = readText(folder.path() / "out");
    run.err = readText(folder.path() / "err");
    return run;
}

}  // namespace demolish::test
