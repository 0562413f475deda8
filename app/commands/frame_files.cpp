// SPDX-License-Identifier: Apache-2.0
// A short queue in front of a few PNG writers; the video takes frames in order on the way.
#include "app/commands/frame_files.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdio>

#include "app/session/output_file.h"
#include "engine/image/contact_sheet.h"
#include "engine/image/png.h"

namespace demolish {
namespace {

constexpr size_t kQueueLength = 8;
constexpr uint64_t kSheetPictures = 12;
constexpr int kTileWidth = 480;

std::filesystem::path frameName(const std::filesystem::path& folder, uint64_t frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04llu.png", static_cast<unsigned long long>(frame));
    return folder / name;
}

/// Evenly spread over the run, first and last among them.
bool isOnSheet(uint64_t frame, uint64_t frames) {
    const uint64_t pictures = std::min(kSheetPictures, frames);
    for (uint64_t i = 0; i < pictures; ++i)
        if (frame == (pictures == 1 ? 0 : i * (frames - 1) / (pictures - 1))) return true;
    return false;
}

}  // namespace

FrameFiles::FrameFiles(const FrameFilesOptions& options) : options_(options) {
    if (options_.video) {
        makeOutputFolder(options_.video->has_parent_path() ? options_.video->parent_path() : ".");
        video_.emplace(*options_.video, options_.width, options_.height, options_.video_fps);
    }
    if (!options_.folder) return;
    makeOutputFolder(*options_.folder);
    const unsigned count = std::clamp(std::thread::hardware_concurrency() / 2, 1u, 8u);
    for (unsigned i = 0; i < count; ++i) writers_.emplace_back([this] { writeJobs(); });
}

FrameFiles::~FrameFiles() {
    stopWriters();
}

void FrameFiles::writeJobs() {
    for (;;) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return closing_ || !jobs_.empty(); });
        if (jobs_.empty()) return;
        const Job job = std::move(jobs_.front());
        jobs_.pop_front();
        changed_.notify_all();
        lock.unlock();
        try {
            engine::writePng(frameName(*options_.folder, job.frame), job.image,
                             {.alpha = options_.alpha, .note = options_.note});
        } catch (...) {
            lock.lock();
            if (!error_) error_ = std::current_exception();
        }
    }
}

void FrameFiles::add(uint64_t frame, engine::Image image) {
    if (video_) video_->write(image.pixels);
    if (!options_.folder) return;
    if (isOnSheet(frame, options_.frames)) {
        const int width = std::min(kTileWidth, image.width);
        const int height = std::max(1, width * image.height / image.width);
        sheet_.emplace(frame, engine::shrink(image, width, height));
    }
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return jobs_.size() < kQueueLength; });
    if (error_) std::rethrow_exception(error_);
    jobs_.push_back({frame, std::move(image)});
    changed_.notify_all();
}

void FrameFiles::stopWriters() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
    writers_.clear();
}

void FrameFiles::finish() {
    stopWriters();
    if (error_) std::rethrow_exception(error_);
    if (options_.folder && !sheet_.empty()) {
        std::vector<engine::Image> pictures;
        for (auto& [frame, image] : sheet_) pictures.push_back(std::move(image));
        const int tile = std::min(kTileWidth, pictures[0].width);
        engine::writePng(*options_.folder / "contact_sheet.png",
                         engine::contactSheet(pictures, options_.sheet_columns, tile));
    }
    if (video_) video_->finish();
    if (options_.folder && std::filesystem::exists(frameName(*options_.folder, options_.frames)))
        spdlog::warn("{} also holds frames of an earlier, longer capture, from {} on",
                     options_.folder->string(),
                     frameName(*options_.folder, options_.frames).filename().string());
}

}  // namespace demolish
