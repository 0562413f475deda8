// SPDX-License-Identifier: Apache-2.0
// Script lines to frames of input.
#include "app/panel/script_driver.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <fstream>
#include <sstream>
#include <utility>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

const std::map<std::string, size_t> kArguments = {
    {"wait", 1},  {"until", 1},         {"set", 2},          {"type", 2},
    {"click", 1}, {"click_picture", 2}, {"drag_picture", 4}, {"move_picture", 4},
    {"key", 1},   {"state", 1},         {"screenshot", 1}};

const std::map<std::string, int> kKeys = {
    {"space", GLFW_KEY_SPACE}, {"r", GLFW_KEY_R},           {"f", GLFW_KEY_F},
    {"tab", GLFW_KEY_TAB},     {"left", GLFW_KEY_LEFT},     {"right", GLFW_KEY_RIGHT},
    {"enter", GLFW_KEY_ENTER}, {"escape", GLFW_KEY_ESCAPE}, {"question", GLFW_KEY_SLASH}};

constexpr int kPatience = 120;        // frames that a control may take to appear (popups, panels that scroll)
constexpr int kLongPatience = 20000;  // frames that a rebuild or a measurement may take

}  // namespace

ScriptDriver::ScriptDriver(const std::filesystem::path& file, ScriptHooks hooks)
    : file_(file), hooks_(std::move(hooks)) {
    std::ifstream in(file);
    if (!in) throw InputFileError("could not read the script " + file.string());
    int number = 0;
    for (std::string text; std::getline(in, text);) {
        ++number;
        std::istringstream words(text.substr(0, text.find('#')));
        Line line;
        line.number = number;
        for (std::string word; words >> word;) line.words.push_back(word);
        if (line.words.empty()) continue;
        const auto known = kArguments.find(line.words[0]);
        if (known == kArguments.end() || line.words.size() != known->second + 1)
            fail(line, "is not understood");
        if (line.words[0] == "until" && !hooks_.conditions.contains(line.words[1]))
            fail(line, "knows nothing of '" + line.words[1] + "'");
        lines_.push_back(std::move(line));
    }
}

void ScriptDriver::fail(const Line& line, const std::string& what) const {
    throw InputFileError(file_.string() + ":" + std::to_string(line.number) + ": '" + line.words[0] + "' " +
                         what);
}

void ScriptDriver::prepareClick(float x, float y, bool ctrl) {
    inputs_.push_back({.x = x, .y = y, .ctrl = ctrl});
    inputs_.push_back({.x = x, .y = y, .left = true, .ctrl = ctrl});
    inputs_.push_back({.x = x, .y = y, .ctrl = ctrl});
    inputs_.push_back({});  // what the click unfolds has its place one frame later
}

void ScriptDriver::preparePicture(const Line& line, const PictureArea& picture) {
    const auto at = [&](size_t word) { return std::stof(line.words[word]); };
    const auto x = [&](float share) {
        return static_cast<float>(picture.x) + share * static_cast<float>(picture.width);
    };
    const auto y = [&](float share) { return share * static_cast<float>(picture.height); };
    if (line.words[0] == "click_picture") {
        prepareClick(x(at(1)), y(at(2)));
        return;
    }
    const bool by_left = line.words[0] == "move_picture";
    constexpr int kSteps = 10;
    inputs_.push_back({.x = x(at(1)), .y = y(at(2))});
    for (int step = 0; step <= kSteps; ++step) {
        const float share = static_cast<float>(step) / kSteps;
        inputs_.push_back({.x = x(at(1) + share * (at(3) - at(1))),
                           .y = y(at(2) + share * (at(4) - at(2))),
                           .left = by_left && step < kSteps,
                           .middle = !by_left && step < kSteps});
    }
}

void ScriptDriver::prepare(const Line& line, const ItemRegistry& items, const PictureArea& picture) {
    const std::string& name = line.words[0];
    const std::string& argument = line.words[1];
    if (name == "wait") {
        inputs_.resize(static_cast<size_t>(std::stoul(argument)), Input{.waits = true});
    } else if (name == "key") {
        const auto key = kKeys.find(argument);
        if (key == kKeys.end()) fail(line, "names no key: " + argument);
        inputs_.push_back({.shift = argument == "question", .key = key->second});
        inputs_.push_back({});
    } else if (name == "click_picture" || name == "drag_picture" || name == "move_picture") {
        preparePicture(line, picture);
    } else {
        const ItemRect* item = items.find(argument);
        if (item == nullptr) fail(line, "finds no control '" + argument + "' on screen");
        const float share = name == "set" ? std::stof(line.words[2]) : 0.5f;
        const float x = item->min_x + share * (item->max_x - item->min_x);
        const float y = 0.5f * (item->min_y + item->max_y);
        prepareClick(x, y, name == "type");
        if (name != "type") return;
        inputs_.push_back({.text = line.words[2]});
        inputs_.push_back({.key = GLFW_KEY_ENTER});
        inputs_.push_back({});
    }
}

void ScriptDriver::inject(ItemRegistry& items, const PictureArea& picture) {
    while (inputs_.empty() && !output_ && next_ < lines_.size()) {
        const Line& line = lines_[next_];
        const std::string& name = line.words[0];
        if (name == "screenshot" || name == "state") {
            output_ = line;
        } else if (name == "until") {
            const bool reached = hooks_.conditions.at(line.words[1])();
            if (!reached && patience_++ == kLongPatience) fail(line, "waited in vain");
            if (!reached) break;
        } else {
            const bool needs_item = name == "set" || name == "click" || name == "type";
            if (needs_item && items.find(line.words[1]) == nullptr && patience_ < kPatience) {
                ++patience_;
                items.want(line.words[1]);
                break;
            }
            prepare(line, items, picture);
        }
        patience_ = 0;
        items.want("");
        ++next_;
    }
    const Input input = inputs_.empty() ? Input{} : inputs_.front();
    if (!inputs_.empty() && !(input.waits && hooks_.conditions.at("within_frame")())) inputs_.pop_front();
    apply(input);
}

void ScriptDriver::apply(const Input& input) {
    HeldInput now = held_;
    if (input.x) now.x = *input.x;
    if (input.y) now.y = *input.y;
    now.left = input.left;
    now.middle = input.middle;
    now.ctrl = input.ctrl;
    now.shift = input.shift;
    now.key = input.key;
    holdInput(now, held_);
    held_ = now;
    for (const char letter : input.text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
}

void ScriptDriver::afterDraw() {
    if (!output_) return;
    const Line line = *std::exchange(output_, std::nullopt);
    const auto& write = line.words[0] == "screenshot" ? hooks_.screenshot : hooks_.state;
    write(line.words[1]);
}

}  // namespace demolish
