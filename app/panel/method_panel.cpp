// SPDX-License-Identifier: Apache-2.0
// How the body breaks: our method, and those of the paper's comparison; into which pieces.
#include "app/panel/widgets.h"

namespace demolish {
namespace {

constexpr const char* kIrregular = "irregular";

/// Bonds can do without a pattern: tough cells are irregular then.
void showPattern(PanelContext& context) {
    Shot& shot = context.shot;
    const bool is_preset = traitsOf(shot.method).pattern_turns.has_value();
    std::vector<std::string> names = patternNames();
    if (!is_preset) names.insert(names.begin(), kIrregular);
    const std::string current = shot.pattern ? patternName(*shot.pattern)
                                : is_preset  ? patternName(usualPattern(shot.method))
                                             : kIrregular;
    const int chosen =
        combo(context, "pattern", "Pattern", names, current,
              "Of the pieces: cut beforehand, or made to come apart along it by stronger bonds within. About "
              "as many as the body has tough cells");
    if (chosen < 0) return;
    shot.pattern = patternOf(names[static_cast<size_t>(chosen)]);
    context.changed = true;
}

}  // namespace

void showMethodPanel(PanelContext& context) {
    Shot& shot = context.shot;
    const int chosen =
        combo(context, "method", "Method", methodNames(), methodName(shot.method),
              "ours: bonds where something breaks. heavy: every bond, all the time. cores: ours on the CPU. "
              "pattern: pieces cut beforehand. pattern-at-impact: turned to where it is hit");
    if (chosen >= 0) {
        shot.method = static_cast<Method>(chosen);
        context.changed = true;
    }
    showPattern(context);
}

}  // namespace demolish
