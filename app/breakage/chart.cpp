// SPDX-License-Identifier: Apache-2.0
// Layout: title above, axes at the left, legend at the right, note below.
#include "app/breakage/chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "app/commands/svg_writer.h"

namespace demolish {
namespace {

constexpr double kWidth = 900, kLeft = 76, kTop = 56, kPlotWidth = 560, kPlotHeight = 400;
constexpr double kRight = kLeft + kPlotWidth, kBottom = kTop + kPlotHeight;
constexpr double kLegendLeft = kRight + 24, kLineHeight = 18, kNoteTop = kBottom + 70;
constexpr const char *kGrid = "#e4e4e4", *kInk = "#222", *kNoteInk = "#444";

std::string number(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

/// px from the top: what the legend and the note need.
double heightOf(const Chart& chart) {
    size_t rows = 0, entries = chart.series.size() + chart.bars.parts.size();
    for (const auto& series : chart.series) rows += linesOf(series.label).size();
    rows += chart.bars.parts.size();
    const double legend =
        kTop + 10 + kLineHeight * static_cast<double>(rows) + 6.0 * static_cast<double>(entries);
    return std::max(kNoteTop + kLineHeight * static_cast<double>(linesOf(chart.note).size()), legend + 20);
}

class Drawing {
  public:
    explicit Drawing(const Chart& chart) : chart_(chart), svg_(kWidth, heightOf(chart)) {}

    std::string finish() {
        axes();
        bars();
        for (const ChartSeries& series : chart_.series) draw(series);
        legend();
        words(linesOf(chart_.note), kLeft, kNoteTop, {.size = 12, .colour = kNoteInk});
        return svg_.finish();
    }

  private:
    SvgPoint place(double x, double y) const {
        return {kLeft + kPlotWidth * (x - chart_.x.low) / (chart_.x.high - chart_.x.low),
                kBottom - kPlotHeight * (y - chart_.y.low) / (chart_.y.high - chart_.y.low)};
    }

    static std::vector<double> ticksOf(const ChartAxis& axis) {
        std::vector<double> ticks;
        const auto count = static_cast<int>((axis.high - axis.low) / axis.step + 1e-6);
        for (int k = 0; k <= count; ++k) ticks.push_back(axis.low + k * axis.step);
        return ticks;
    }

    void axes() {
        svg_.text({kLeft, 30}, chart_.title, {.size = 16, .bold = true});
        for (const double tick : ticksOf(chart_.x)) {
            const double x = place(tick, 0).x;
            svg_.line({x, kTop}, {x, kBottom}, kGrid);
            svg_.text({x, kBottom + 18}, number(tick, chart_.x.decimals), {.anchor = "middle"});
        }
        for (const double tick : ticksOf(chart_.y)) {
            const double y = place(chart_.x.low, tick).y;
            svg_.line({kLeft, y}, {kRight, y}, kGrid);
            svg_.text({kLeft - 8, y + 4}, number(tick, chart_.y.decimals), {.anchor = "end"});
        }
        svg_.line({kLeft, kBottom}, {kRight, kBottom}, kInk);
        svg_.line({kLeft, kTop}, {kLeft, kBottom}, kInk);
        svg_.text({kLeft + kPlotWidth / 2, kBottom + 42}, chart_.x.label, {.anchor = "middle"});
        svg_.text({20, kTop + kPlotHeight / 2}, chart_.y.label, {.anchor = "middle", .turn = -90});
    }

    void bars() {
        const ChartStack& stack = chart_.bars;
        for (size_t k = 0; k < stack.x.size(); ++k) {
            double base = 0;
            for (const auto& part : stack.parts) {
                const SvgPoint low = place(stack.x[k] - stack.width / 2, base + part.heights[k]);
                const SvgPoint high = place(stack.x[k] + stack.width / 2, base);
                svg_.rectangle(low, high.x - low.x, high.y - low.y, part.colour.c_str());
                base += part.heights[k];
            }
        }
    }

    void draw(const ChartSeries& series) {
        for (size_t k = 1; series.width > 0 && k < series.x.size(); ++k)
            svg_.line(place(series.x[k - 1], series.y[k - 1]), place(series.x[k], series.y[k]),
                      series.colour.c_str(), series.width, series.dash.c_str());
        for (size_t k = 0; k < series.x.size(); ++k) {
            if (!series.error_low.empty()) errorBar(series, k);
            marker(place(series.x[k], series.y[k]), series);
        }
    }

    void errorBar(const ChartSeries& series, size_t k) {
        SvgPoint low = place(series.x[k], series.error_low[k]),
                 high = place(series.x[k], series.error_high[k]);
        low.x = high.x += series.error_shift;
        for (const SvgPoint& end : {low, high})
            svg_.line({end.x - 4, end.y}, {end.x + 4, end.y}, series.colour.c_str());
        svg_.line(low, high, series.colour.c_str());
    }

    void marker(const SvgPoint& at, const ChartSeries& series) {
        const double r = series.marker;
        if (!(r > 0)) return;
        const int corner_count = series.open_diamond ? 4 : 20;
        std::vector<SvgPoint> corners;
        for (int k = 0; k < corner_count; ++k) {
            const double turn = 2 * 3.14159265358979 * k / corner_count;
            corners.push_back({at.x + r * std::cos(turn), at.y + r * std::sin(turn)});
        }
        if (!series.open_diamond) return svg_.area(corners, series.colour.c_str());
        svg_.area(corners, "#fff");
        for (size_t k = 0; k < corners.size(); ++k)
            svg_.line(corners[k], corners[(k + 1) % corners.size()], series.colour.c_str(), 2.5);
    }

    void legend() {
        double y = kTop + 10;
        for (auto series = chart_.series.rbegin(); series != chart_.series.rend(); ++series) {
            if (series->width > 0)
                svg_.line({kLegendLeft, y - 4}, {kLegendLeft + 28, y - 4}, series->colour.c_str(),
                          series->width, series->dash.c_str());
            marker({kLegendLeft + 14, y - 4}, *series);
            y = words(linesOf(series->label), kLegendLeft + 36, y, {}) + 6;
        }
        for (auto part = chart_.bars.parts.rbegin(); part != chart_.bars.parts.rend(); ++part) {
            svg_.rectangle({kLegendLeft + 4, y - 12}, 20, 14, part->colour.c_str());
            y = words({part->label}, kLegendLeft + 36, y, {}) + 6;
        }
    }

    /// Returns where the next line would stand.
    double words(const std::vector<std::string>& lines, double x, double y, const SvgTextStyle& style) {
        for (const std::string& line : lines) {
            svg_.text({x, y}, line, style);
            y += kLineHeight;
        }
        return y;
    }

    const Chart& chart_;
    SvgWriter svg_;
};

}  // namespace

std::string chartSvg(const Chart& chart) {
    return Drawing(chart).finish();
}

}  // namespace demolish
