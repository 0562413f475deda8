// SPDX-License-Identifier: Apache-2.0
// Drives the window by a script instead of a hand: what a window test and a demonstration need. Input goes
// through Dear ImGui's io, so that everything behind it is the real program.
#pragma once
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/panel/input_events.h"
#include "app/panel/item_registry.h"
#include "app/panel/layout.h"

namespace demolish {

/// One line a command:
///   wait N                 N frames; turns of the window within a simulated frame do not count
///   until rebuilt          until no rebuild is waiting or running
///   until building         until a rebuild runs on its worker
///   until within_frame     until a turn of the window ends within a simulated frame
///   until measuring        until a threshold is being measured
///   until measured         until none is
///   set ID FRACTION        presses the slider ID at this share of its width
///   type ID TEXT           Ctrl-click on the slider, TEXT, Enter
///   click ID               a control; ID as panels name it ("transport.reset")
///   click_picture X Y      a left click at shares of the picture's width and height
///   drag_picture X Y X Y   a middle-button drag
///   move_picture X Y X Y   a left-button drag
///   key NAME               space, r, f, tab, left, right, enter, escape, question
///   screenshot FILE        the whole window, PNG
///   state FILE             what the session says, JSON
struct ScriptHooks {
    std::map<std::string, std::function<bool()>> conditions;  ///< what `until` can wait for
    std::function<void(const std::filesystem::path&)> screenshot, state;
};

class ScriptDriver {
  public:
    /// Throws InputFileError (unreadable, unknown command).
    ScriptDriver(const std::filesystem::path& file, ScriptHooks hooks);

    /// Between the backend's and ImGui's NewFrame: overrides this frame's input.
    void inject(ItemRegistry& items, const PictureArea& picture);
    /// After the frame was drawn: screenshots and state of what is on screen.
    void afterDraw();
    bool finished() const { return next_ >= lines_.size() && inputs_.empty(); }

  private:
    struct Line {
        std::vector<std::string> words;
        int number = 0;
    };
    struct Input {
        std::optional<float> x = {}, y = {};  ///< px of the window
        bool left = false, middle = false, ctrl = false, shift = false;
        int key = -1;
        bool waits = false;  ///< for the end of a simulated frame
        std::string text = {};
    };
    void prepare(const Line& line, const ItemRegistry& items, const PictureArea& picture);
    void prepareClick(float x, float y, bool ctrl = false);
    void preparePicture(const Line& line, const PictureArea& picture);
    void apply(const Input& input);
    [[noreturn]] void fail(const Line& line, const std::string& what) const;

    std::filesystem::path file_;
    ScriptHooks hooks_;
    std::vector<Line> lines_;
    size_t next_ = 0;
    std::deque<Input> inputs_;
    std::optional<Line> output_;           ///< screenshot or state to write after drawing
    HeldInput held_ = {.x = -1, .y = -1};  ///< in the last frame
    int patience_ = 0;                     ///< frames left until a missing control is an error
};

}  // namespace demolish
