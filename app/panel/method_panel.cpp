// SPDX-License-Identifier: Apache-2.0
// How the body breaks: our method, and those of the paper's comparison. A change makes a new solver on the
// same cells.
#include "app/panel/widgets.h"

namespace demolish {
namespace {

void showPattern(PanelContext& context) {
    Shot& shot = context.shot;
    const Pattern pattern = shot.pattern.value_or(usualPattern(shot.method));
    const int chosen = combo(context, "pattern", "Pattern", patternNames(), patternName(pattern),
                             "Of the pieces; about as many as the body has tough cells");
    if (chosen < 0) return;
    shot.pattern = static_cast<Pattern>(chosen);
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
    if (traitsOf(shot.method).pattern_turns) showPattern(context);
}

}  // namespace demolish
