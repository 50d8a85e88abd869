// SPDX-License-Identifier: MIT
#include "app/diagram/svg.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "techniques/foundation/image/image.h"

namespace shadowlab::diagram {

namespace {

constexpr double kHead = 16, kHalfHead = 6.5; ///< length and half the width of an arrow's head

/// Two digits after the point: finer than any screen shows. No locale turns the point into a comma.
std::string number(double value) {
    std::array<char, 64> text{};
    const double rounded = std::round(value * 100) / 100 + 0.0; // no "-0"
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), rounded, std::chars_format::fixed, 2);
    return error == std::errc{} ? std::string(text.data(), end) : "0";
}

std::string attribute(std::string_view name, double value) {
    return " " + std::string(name) + "=\"" + number(value) + "\"";
}

std::string attributes(const Stroke& stroke) {
    return " stroke=\"" + stroke.color + "\"" + attribute("stroke-width", stroke.width) +
           (stroke.isDashed ? " stroke-dasharray=\"9 7\"" : "");
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text)
        switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        default: out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c; // no control character is allowed in XML
        }
    return out;
}

std::string pair(dvec2 p) { return number(p.x) + " " + number(p.y); }

} // namespace

std::string colorText(const vec3& linear) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", image::srgbFromLinear(linear.r),
                  image::srgbFromLinear(linear.g), image::srgbFromLinear(linear.b));
    return text.data();
}

void Svg::line(dvec2 from, dvec2 to, const Stroke& stroke) {
    body_ += "<path d=\"M" + pair(from) + "L" + pair(to) + "\"" + attributes(stroke) + "/>\n";
}

void Svg::arrow(dvec2 from, dvec2 to, const Stroke& stroke, double share) {
    const double length = glm::length(to - from);
    if (length == 0) return;
    const dvec2 along = (to - from) / length, across(-along.y, along.x);
    const double grow = std::max(1.0, stroke.width / 3);
    dvec2 tip = glm::mix(from, to, share);
    if (share < 1) tip += 0.5 * kHead * grow * along; // the head's middle is meant
    const dvec2 foot = tip - kHead * grow * along;
    line(from, share < 1 ? to : foot + 0.5 * along, stroke);
    body_ += "<path d=\"M" + pair(tip) + "L" + pair(foot + kHalfHead * grow * across) + "L" +
             pair(foot - kHalfHead * grow * across) + "Z\" fill=\"" + stroke.color + "\"/>\n";
}

void Svg::segments(std::span<const dvec2> points, const Stroke& stroke) {
    if (points.size() < 2) return;
    body_ += "<path d=\"";
    for (std::size_t i = 0; i + 1 < points.size(); i += 2)
        body_ += "M" + pair(points[i]) + "L" + pair(points[i + 1]);
    body_ += "\"" + attributes(stroke) + "/>\n";
}

void Svg::path(std::span<const dvec2> points, bool isClosed, const std::string& fill, const Stroke& stroke) {
    if (points.size() < 2) return;
    body_ += "<path d=\"M";
    for (std::size_t i = 0; i < points.size(); ++i)
        body_ += (i ? "L" : "") + pair(points[i]);
    body_ += std::string(isClosed ? "Z\"" : "\"") + (fill.empty() ? "" : " fill=\"" + fill + "\"") +
             attributes(stroke) + "/>\n";
}

void Svg::circle(dvec2 centre, double radius, const std::string& fill, const Stroke& stroke, std::string_view name) {
    body_ += "<circle" + (name.empty() ? "" : " class=\"" + std::string(name) + "\"") + attribute("cx", centre.x) +
             attribute("cy", centre.y) + attribute("r", radius) + " fill=\"" + fill + "\"" + attributes(stroke) +
             "/>\n";
}

void Svg::rectangle(dvec2 corner, dvec2 size, const std::string& fill, const Stroke& stroke, double rounding) {
    body_ += "<rect" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", size.x) +
             attribute("height", size.y) + attribute("rx", rounding) + " fill=\"" + fill + "\"" + attributes(stroke) +
             "/>\n";
}

void Svg::text(dvec2 place, std::string_view text, const TextStyle& style) {
    constexpr std::array kAnchors{"start", "middle", "end"};
    const std::string common = attribute("x", place.x) + attribute("y", place.y) + attribute("font-size", style.size) +
                               " text-anchor=\"" + kAnchors[static_cast<std::size_t>(style.anchor)] + "\"" +
                               (style.isBold ? " font-weight=\"bold\"" : "") +
                               (style.isItalic ? " font-style=\"italic\"" : "");
    // Twice: not every program that shows SVG can paint the rim below the letters by itself.
    body_ += "<text class=\"rim\"" + common + " aria-hidden=\"true\">" + escaped(text) + "</text>\n";
    body_ += "<text" + common + " fill=\"" + style.color + "\">" + escaped(text) + "</text>\n";
}

void Svg::breakMark(dvec2 place, dvec2 direction, const Stroke& stroke) {
    const dvec2 along = glm::normalize(direction), across(-along.y, along.x);
    for (const double side : {-5.0, 5.0})
        line(place + side * along - 11.0 * (across + 0.4 * along), place + side * along + 11.0 * (across + 0.4 * along),
             {stroke.color, 3, false});
}

void Svg::beginClip(dvec2 corner, dvec2 size) {
    const std::string id = "clip" + std::to_string(++clips_);
    body_ += "<clipPath id=\"" + id + "\"><rect" + attribute("x", corner.x) + attribute("y", corner.y) +
             attribute("width", size.x) + attribute("height", size.y) + "/></clipPath>\n<g clip-path=\"url(#" + id +
             ")\">\n";
}

void Svg::endClip() { body_ += "</g>\n"; }

std::string Svg::document(std::string_view title) const {
    const std::string width = number(size_.x), height = number(size_.y);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
           "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
           "\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" stroke-linecap=\"round\" fill=\"none\">\n<title>" +
           escaped(title) +
           "</title>\n<style>.rim{fill:#ffffff;stroke:#ffffff;stroke-width:6px;stroke-linejoin:round}</style>\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
           body_ + "</svg>\n";
}

} // namespace shadowlab::diagram
