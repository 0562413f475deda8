// SPDX-License-Identifier: Apache-2.0
// Where each named control is on screen: a script finds sliders and buttons by name, not by pixel.
#pragma once
#include <map>
#include <string>

namespace demolish {

struct ItemRect {
    float min_x = 0, min_y = 0, max_x = 0, max_y = 0;  ///< px of the window
};

class ItemRegistry {
  public:
    void clear() { items_.clear(); }
    void note(const std::string& id, const ItemRect& rect) { items_[id] = rect; }
    /// A control that a script looks for: the panel that has it scrolls it into sight.
    void want(const std::string& id) { wanted_ = id; }
    bool isWanted(const std::string& id) const { return id == wanted_; }
    /// Null when the control is not on screen.
    const ItemRect* find(const std::string& id) const {
        const auto found = items_.find(id);
        return found == items_.end() ? nullptr : &found->second;
    }

  private:
    std::map<std::string, ItemRect> items_;
    std::string wanted_;
};

}  // namespace demolish
