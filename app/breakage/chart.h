// SPDX-License-Identifier: Apache-2.0
// Plots as SVG text: axes with ticks, lines with error bars, points, stacked bars, a legend.
#pragma once
#include <string>
#include <vector>

namespace demolish {

struct ChartAxis {
    std::string label;
    double low = 0, high = 1, step = 0.1;  ///< ticks from `low` on
    int decimals = 1;
};

/// A line through points, or points alone, drawn over those before it and named before them in the legend.
/// `error_low/high`: as long as y, or empty.
struct ChartSeries {
    std::string label;
    std::vector<double> x, y, error_low, error_high;
    std::string colour = "#000000";
    double width = 2;           ///< px; 0: no line
    std::string dash;           ///< as in stroke-dasharray
    double marker = 4;          ///< px, radius; 0: none
    double error_shift = 0;     ///< px to the right, so that bars of two lines stand beside each other
    bool open_diamond = false;  ///< a large hollow diamond instead of a disc
};

/// Bars at x, one on the other in the order of the parts.
struct ChartStack {
    struct Part {
        std::string label, colour;
        std::vector<double> heights;
    };
    std::vector<double> x;
    double width = 1;  ///< in units of x
    std::vector<Part> parts;
};

struct Chart {
    std::string title, note;  ///< the note stands below the picture, its lines parted by '\n'
    ChartAxis x, y;
    ChartStack bars;
    std::vector<ChartSeries> series;
};

/// A whole SVG file, 900 px wide. Numbers are written with fixed decimals: equal input, equal bytes.
std::string chartSvg(const Chart& chart);

}  // namespace demolish
