// SPDX-License-Identifier: MIT
#include "app/picture/outside/label_painter.h"

#include <algorithm>
#include <cmath>

#include "app/context/assets.h"
#include "techniques/foundation/gl/baseline.h"

namespace shadowlab::picture {

namespace {

constexpr image::Color8 kPlateColor{16, 16, 18, 255}, kTextColor{245, 245, 245, 255}; // of titles and legends, too
// In em.
constexpr double kBar = 0.3, kPad = 0.3;
constexpr double kLine = 0.11; ///< width of the line to the thing
constexpr double kDot = 0.34;  ///< of the dot where it ends

} // namespace

LabelPainter::LabelPainter() : font_(context::assetsRoot() / "fonts" / "DejaVuSans.ttf") {}

dvec2 LabelPainter::sizeOf(const std::string& text, double em) const {
    const image::TextSize size = font_.measure(text, em);
    return glm::ceil(dvec2(size.width + (kBar + 2 * kPad) * em, size.height + 0.5 * kPad * em));
}

image::Image LabelPainter::plateOf(const PlacedLabel& label, double em) const {
    const dvec2 size = label.box.upper - label.box.lower;
    image::Image plate(static_cast<int>(size.x), static_cast<int>(size.y), kPlateColor);
    const int bar = std::max(2, static_cast<int>(kBar * em));
    image::fillRect(plate, 0, 0, bar, plate.height, image::encoded(label.colorLinear));
    font_.draw(plate, static_cast<int>((kBar + kPad) * em), static_cast<int>(0.25 * kPad * em), label.text, em, kTextColor);
    return plate;
}

void LabelPainter::draw(const std::vector<PlacedLabel>& labels, double em, const ShapePainter& lines, ivec2 size) const {
    const auto onScreen = [&](const dvec2& pixel) { return vec3(pixel.x, size.y - pixel.y, 0); };
    for (const PlacedLabel& label : labels) {
        if (label.standsOnIt()) continue;
        const vec3 from = onScreen(label.lineStart()), to = onScreen(label.place);
        lines.drawOnPicture({{from, to}}, label.colorLinear, std::max(1.0f, static_cast<float>(kLine * em)), size);
    }
    for (const PlacedLabel& label : labels) { // over all lines
        const vec3 at = onScreen(label.place);
        if (!label.standsOnIt()) lines.drawOnPicture({{at, at}}, label.colorLinear, static_cast<float>(kDot * em), size);
    }
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    for (const PlacedLabel& label : labels) {
        const image::Image plate = plateOf(label, em);
        const gl::Texture2D texture(GL_SRGB8_ALPHA8, {plate.width, plate.height}, "label");
        texture.bind(0);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, plate.width, plate.height, GL_RGBA, GL_UNSIGNED_BYTE, plate.rgba.data());
        const ivec2 corner(label.box.lower);
        const int top = size.y - 1 - corner.y;
        glViewport(corner.x, top + 1 - plate.height, plate.width, plate.height);
        plate_.use();
        plate_.set("label", 0);
        plate_.set("upperLeft", vec2(corner.x, top));
        gl::drawFullscreenTriangle();
    }
    glViewport(0, 0, size.x, size.y);
    glEnable(GL_DEPTH_TEST);
}

} // namespace shadowlab::picture
