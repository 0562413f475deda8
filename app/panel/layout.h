// SPDX-License-Identifier: Apache-2.0
// Where the panels stand: a column at the left, a transport bar and a status line below; the picture has the
// rest.
#pragma once
#include "app/panel/panel_context.h"

namespace demolish {

/// Part of the window that the picture fills, px from the top left.
struct PictureArea {
    int x = 0, y = 0, width = 0, height = 0;
};

PictureArea pictureArea(const PanelState& state);
void showPanels(PanelContext& context);

}  // namespace demolish
