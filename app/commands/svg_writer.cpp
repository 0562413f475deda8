// SPDX-License-Identifier: Apache-2.0
// SVG 1.1 elements, a line each.
#include "app/commands/svg_writer.h"

#include <cstdio>

namespace demolish {
namespace {

/// A hundredth of a pixel is finer than any screen.
std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string escaped(const std::string& words) {
    std::string text;
    for (const char c : words) switch (c) {
            case '&':
                text += "&amp;";
                break;
            case '<':
                text += "&lt;";
                break;
            case '>':
                text += "&gt;";
                break;
            default:
                text += c;
        }
    return text;
}

}  // namespace

SvgWriter::SvgWriter(double width, double height) : width_(width), height_(height) {
    rectangle({0, 0}, width, height, "#fff");
}

void SvgWriter::rectangle(const SvgPoint& low, double width, double height, const char* colour) {
    body_ += "<rect" + attribute("x", number(low.x)) + attribute("y", number(low.y)) +
             attribute("width", number(width)) + attribute("height", number(height)) +
             attribute("fill", colour) + "/>\n";
}

void SvgWriter::line(const SvgPoint& from, const SvgPoint& to, const char* colour, double width,
                     const char* dashes) {
    body_ += "<line" + attribute("x1", number(from.x)) + attribute("y1", number(from.y)) +
             attribute("x2", number(to.x)) + attribute("y2", number(to.y)) + attribute("stroke", colour) +
             attribute("stroke-width", number(width)) +
             (*dashes != '\0' ? attribute("stroke-dasharray", dashes) : "") + "/>\n";
}

void SvgWriter::area(const std::vector<SvgPoint>& corners, const char* colour) {
    std::string points;
    for (const auto& corner : corners) {
        points += number(corner.x);
        points += ',';
        points += number(corner.y);
        points += ' ';
    }
    body_ += "<polygon" + attribute("points", points) + attribute("fill", colour) + "/>\n";
}

void SvgWriter::text(const SvgPoint& at, const std::string& words, const SvgTextStyle& style) {
    const std::string place = number(at.x) + " " + number(at.y);
    body_ +=
        "<text" + attribute("x", number(at.x)) + attribute("y", number(at.y)) +
        attribute("font-size", number(style.size)) + attribute("text-anchor", style.anchor) +
        attribute("fill", style.colour) + (style.bold ? attribute("font-weight", "bold") : "") +
        (style.turn != 0 ? attribute("transform", "rotate(" + number(style.turn) + " " + place + ")") : "") +
        ">" + escaped(words) + "</text>\n";
}

std::string SvgWriter::finish() const {
    const std::string size = number(width_) + " " + number(height_);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", number(width_)) +
           attribute("height", number(height_)) + attribute("viewBox", "0 0 " + size) +
           attribute("font-family", "DejaVu Sans, Helvetica, Arial, sans-serif") + ">\n" + body_ + "</svg>\n";
}

}  // namespace demolish
