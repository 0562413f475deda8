// SPDX-License-Identifier: Apache-2.0
// A drawing of rectangles, lines, areas and words as an SVG file. Coordinates in px, y down, as SVG has them.
#pragma once
#include <string>
#include <vector>

namespace demolish {

struct SvgPoint {
    double x = 0, y = 0;
};

/// How words stand: `anchor` is start, middle or end; `turn` in degrees, clockwise, about the point.
struct SvgTextStyle {
    double size = 13;
    const char* anchor = "start";
    const char* colour = "#222";
    bool bold = false;
    double turn = 0;
};

class SvgWriter {
  public:
    /// White ground.
    SvgWriter(double width, double height);

    void rectangle(const SvgPoint& low, double width, double height, const char* colour);
    /// `dashes` as SVG's stroke-dasharray; empty: a whole line.
    void line(const SvgPoint& from, const SvgPoint& to, const char* colour, double width = 1,
              const char* dashes = "");
    void area(const std::vector<SvgPoint>& corners, const char* colour);
    void text(const SvgPoint& at, const std::string& words, const SvgTextStyle& style = {});

    /// The whole file.
    std::string finish() const;

  private:
    std::string body_;
    double width_, height_;
};

}  // namespace demolish
