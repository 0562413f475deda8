// SPDX-License-Identifier: Apache-2.0
// Starts the reader, takes its answer, and finds words for what became of it.
#include "app/reading/model_reader.h"

#include <csignal>
#include <utility>

#include "app/process/child_process.h"
#include "app/reading/mesh_stream.h"
#include "app/reading/model_service.h"
#include "app/reading/reading_limits.h"
#include "app/reading/set_text.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSaveItAnew = "save it anew, in a format such as OBJ, PLY, STL, glTF or FBX";

constexpr const char* kNoAnswer = "got no usable answer from the reader; save it anew";

std::string& readerProgram() {
    static std::string program;
    return program;
}

/// One file and the child that reads it.
class Reading {
  public:
    Reading(const fs::path& file, const std::vector<std::string>& words, const ProgressCallback& progress)
        : file_(file),
          progress_(progress),
          most_time_(mostReadingTime(file)),
          deadline_(ChildProcess::Clock::now() + most_time_.waiting),
          child_({.words = words,
                  .program = readerProgram(),
                  .output = ChildStream::kPiped,
                  .errors = ChildStream::kNothing,
                  .own_group = true}) {}

    ModelAnswer answer(const std::shared_ptr<const ModelLooks>& known = {}) {
        try {
            return readAnswer([this](std::span<uint8_t> bytes) { fill(bytes); }, known);
        } catch (const BrokenStream&) {
            return ModelRefusal{"The model '" + file_.string() + "' " + whatWentWrong() + "."};
        }
    }

  private:
    void fill(std::span<uint8_t> bytes) {
        constexpr std::chrono::milliseconds kBetweenQuestions{50};
        while (!bytes.empty()) {
            if (progress_ && !progress_(0, "reading the model")) throw Cancelled();
            const auto got = child_.read(bytes, kBetweenQuestions);
            if (got && *got == 0) throw BrokenStream("it ends too early");
            if (got) bytes = bytes.subspan(*got);
            if (ChildProcess::Clock::now() > deadline_) throw BrokenStream("it does not come");
        }
    }

    /// Its answer was none, and so it is about to end, or hangs.
    std::string whatWentWrong() {
        const auto end = child_.waitUntil(std::min(deadline_, ChildProcess::Clock::now() + kGrace));
        const auto tooSlow = [](std::chrono::seconds limit) {
            return "took longer than " + std::to_string(limit.count()) + " s to be read; " + kSaveItAnew;
        };
        if (!end && ChildProcess::Clock::now() >= deadline_) return tooSlow(most_time_.waiting);
        if (!end) return kNoAnswer;
        if (end->signal == SIGXCPU) return tooSlow(most_time_.computing);
        if (end->signal == SIGKILL)
            return "had its reader killed, as when memory runs out; end other programs or make it coarser";
        if (end->signal != 0) return std::string("crashed the reader; ") + kSaveItAnew;
        if (end->exit_code == kOutOfMemory)
            return "needs more than " + std::to_string(mostReadingGibibytes()) +
                   " GiB of memory to be read; make it coarser, or " + kSaveItAnew;
        return kNoAnswer;
    }

    static constexpr std::chrono::seconds kGrace{10};
    const fs::path& file_;
    const ProgressCallback& progress_;
    const ReadingTime most_time_;
    const ChildProcess::Clock::time_point deadline_;
    ChildProcess child_;
};

/// Of the kind that is asked for. Throws InputFileError with the sentence of a refusal.
template <class Kind>
Kind taken(ModelAnswer answer, const fs::path& file) {
    if (const auto* refusal = std::get_if<ModelRefusal>(&answer)) throw InputFileError(refusal->sentence);
    if (auto* kind = std::get_if<Kind>(&answer)) return std::move(*kind);
    throw InputFileError("The model '" + file.string() + "' " + kNoAnswer + ".");
}

template <class Ask>
auto asked(const fs::path& file, const std::vector<std::string>& words, const ProgressCallback& progress,
           const Ask& ask) {
    try {
        Reading reading(file, words, progress);
        return ask(reading);
    } catch (const ChildError& error) {
        throw DeviceError(std::string("could not start the reader of model files: ") + error.what());
    }
}

}  // namespace

void setModelReader(const std::string& program) {
    readerProgram() = program;
}

std::vector<ImportedModel> readModels(const fs::path& file, const std::vector<std::string>& nodes,
                                      const ProgressCallback& progress) {
    if (readerProgram().empty()) return importModels(file, nodes);
    std::vector<std::string> words = {"demolish", kReadModelCommand, file.string()};
    words.insert(words.end(), nodes.begin(), nodes.end());
    return asked(file, words, progress, [&](Reading& reading) {
        std::vector<ImportedModel> models;
        for (size_t i = 0; i < nodes.size(); ++i)
            models.push_back(
                taken<ImportedModel>(reading.answer(models.empty() ? nullptr : models.front().looks), file));
        return models;
    });
}

ImportedModel readModel(const fs::path& file, const std::string& node, const ProgressCallback& progress) {
    return std::move(readModels(file, {node}, progress).front());
}

ModelSet readModelSet(const fs::path& file) {
    if (readerProgram().empty()) return importSet(file);
    const auto text = asked(file, {"demolish", kReadSetCommand, file.string()}, {}, [&](Reading& reading) {
        return taken<ModelSetText>(reading.answer(), file).text;
    });
    try {
        return setOfText(text);
    } catch (const BrokenStream&) {
        throw InputFileError("The model '" + file.string() + "' " + kNoAnswer + ".");
    }
}

std::shared_ptr<const SolidMesh> readSolidMesh(const fs::path& file, const MeshPlacement& placement,
                                               const ProgressCallback& progress) {
    ImportedModel model = readModel(file, placement.part.node, progress);
    return makeSolidMesh(std::move(model.mesh), file, placement, std::move(model.looks));
}

}  // namespace demolish
