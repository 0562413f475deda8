// SPDX-License-Identifier: Apache-2.0
// Set-up errors: each ends in one sentence and its own exit code. Step errors are status bits (stats.h).
#pragma once
#include <stdexcept>
#include <string>

namespace demolish {

enum class ExitCode : int { kDone = 0, kUsage = 2, kInputFile = 3, kDevice = 4, kNumerical = 5, kOutput = 6 };

/// `what()` is one sentence that names the file or the value and the remedy.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

struct UsageError : Error {
    explicit UsageError(const std::string& sentence) : Error(ExitCode::kUsage, sentence) {}
};
struct InputFileError : Error {
    explicit InputFileError(const std::string& sentence) : Error(ExitCode::kInputFile, sentence) {}
};
struct DeviceError : Error {
    explicit DeviceError(const std::string& sentence) : Error(ExitCode::kDevice, sentence) {}
};
struct NumericalError : Error {
    explicit NumericalError(const std::string& sentence) : Error(ExitCode::kNumerical, sentence) {}
};
struct OutputError : Error {
    explicit OutputError(const std::string& sentence) : Error(ExitCode::kOutput, sentence) {}
};
/// The user pressed Cancel; nothing is wrong and nothing changed.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace demolish
