// SPDX-License-Identifier: Apache-2.0
// Finished frames to PNG files, contact sheet and video, off the thread that simulates.
#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/commands/video_pipe.h"
#include "engine/image/image.h"

namespace demolish {

struct FrameFilesOptions {
    std::optional<std::filesystem::path> folder;  ///< PNG frames and contact sheet
    std::optional<std::filesystem::path> video;
    uint64_t frames = 0;        ///< pictures in all
    int sheet_columns = 4;      ///< of the contact sheet
    int width = 0, height = 0;  ///< px
    double video_fps = 60;
    bool alpha = false;  ///< of the frames' PNG, straight
    std::string note{};  ///< in the frames' PNG: how light became colour
};

class FrameFiles {
  public:
    /// Makes the folder and starts ffmpeg. Throws OutputError.
    explicit FrameFiles(const FrameFilesOptions& options);
    ~FrameFiles();
    FrameFiles(const FrameFiles&) = delete;
    FrameFiles& operator=(const FrameFiles&) = delete;

    /// Each picture once, a video's in order. Waits when the writers lag far behind. Throws what a writer
    /// threw.
    void add(uint64_t frame, engine::Image image);
    /// Waits for the writers, writes the contact sheet, ends the video. Throws OutputError.
    void finish();

  private:
    struct Job {
        uint64_t frame;
        engine::Image image;
    };
    void writeJobs();
    void stopWriters();

    FrameFilesOptions options_;
    std::optional<VideoPipe> video_;
    std::map<uint64_t, engine::Image> sheet_;  ///< by frame
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    std::exception_ptr error_;
    bool closing_ = false;
    std::vector<std::jthread> writers_;
};

}  // namespace demolish
