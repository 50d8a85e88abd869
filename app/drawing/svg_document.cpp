// A drawing as the text of an SVG file.
// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <cmath>

#include "app/drawing/drawing.h"
#include "app/drawing/markup.h"

namespace shadowlab::drawing {

namespace {

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

std::string attributes(const std::string& fill, const Stroke& stroke) {
    static const std::string dashes = " stroke-dasharray=\"" + std::to_string(std::lround(kDashLength)) + " " +
                                      std::to_string(std::lround(kDashGap)) + "\"";
    return (fill.empty() ? "" : " fill=\"" + fill + "\"") +
           (stroke.width > 0 ? " stroke=\"" + stroke.color + "\"" + attribute("stroke-width", stroke.width) : "") +
           (stroke.isDashed ? dashes : "");
}

std::string pair(dvec2 p) { return number(p.x) + " " + number(p.y); }

std::string box(dvec2 corner, dvec2 size) {
    return attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", size.x) +
           attribute("height", size.y);
}

/// Writes one mark after another.
struct Writer {
    std::string body;
    int clips = 0;

    void operator()(const Line& line) {
        body += "<path d=\"M";
        for (std::size_t i = 0; i < line.points.size(); ++i)
            body += (i ? "L" : "") + pair(line.points[i]);
        body += (line.isClosed ? "Z\"" : "\"") + attributes(line.fill, line.stroke) + "/>\n";
    }
    void operator()(const Segments& segments) {
        body += "<path d=\"";
        for (std::size_t i = 0; i + 1 < segments.points.size(); i += 2)
            body += "M" + pair(segments.points[i]) + "L" + pair(segments.points[i + 1]);
        body += "\"" + attributes("", segments.stroke) + "/>\n";
    }
    void operator()(const Surface& surface) {
        body += "<path d=\"";
        for (std::size_t i = 0; i + 2 < surface.points.size(); i += 3)
            body += "M" + pair(surface.points[i]) + "L" + pair(surface.points[i + 1]) + "L" +
                    pair(surface.points[i + 2]) + "Z";
        body += "\"" + attributes(surface.fill, {"", 0, false}) + attribute("fill-opacity", surface.opacity) + "/>\n";
    }
    void operator()(const Circle& circle) {
        body += "<circle" + (circle.name.empty() ? "" : " class=\"" + circle.name + "\"") +
                attribute("cx", circle.centre.x) + attribute("cy", circle.centre.y) + attribute("r", circle.radius) +
                attributes(circle.fill, circle.stroke) + "/>\n";
    }
    void operator()(const Rectangle& rectangle) {
        body += "<rect" + box(rectangle.corner, rectangle.size) + attribute("rx", rectangle.rounding) +
                attributes(rectangle.fill, rectangle.stroke) + "/>\n";
    }
    void operator()(const TextLine& text) {
        constexpr std::array kAnchors{"start", "middle", "end"};
        const TextStyle& style = text.style;
        const std::string common =
            attribute("x", text.place.x) + attribute("y", text.place.y) + attribute("font-size", style.size) +
            " text-anchor=\"" + kAnchors[static_cast<std::size_t>(style.anchor)] + "\"" +
            (style.isBold ? " font-weight=\"bold\"" : "") + (style.isItalic ? " font-style=\"italic\"" : "");
        // Twice: not every program that shows SVG can paint the rim below the letters by itself.
        if (style.hasRim)
            body += "<text class=\"rim\"" + common + " aria-hidden=\"true\">" + escapedMarkup(text.text) + "</text>\n";
        body += "<text" + common + " fill=\"" + style.color + "\">" + escapedMarkup(text.text) + "</text>\n";
    }
    void operator()(const ClipBegin& clip) {
        const std::string id = "clip" + std::to_string(++clips);
        body += "<clipPath id=\"" + id + "\"><rect" + box(clip.corner, clip.size) +
                "/></clipPath>\n<g clip-path=\"url(#" + id + ")\">\n";
    }
    void operator()(const ClipEnd&) { body += "</g>\n"; }
};

} // namespace

std::string Drawing::document(std::string_view title) const {
    Writer writer;
    for (const Mark& mark : marks_)
        std::visit(writer, mark);
    const std::string width = number(size_.x), height = number(size_.y);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
           "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
           "\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" stroke-linecap=\"round\" fill=\"none\">\n<title>" +
           escapedMarkup(title) +
           "</title>\n<style>.rim{fill:#ffffff;stroke:#ffffff;stroke-width:" + std::to_string(std::lround(kRimWidth)) +
           "px;stroke-linejoin:round}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
           writer.body + "</svg>\n";
}

} // namespace shadowlab::drawing
