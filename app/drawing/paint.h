// Paints a drawing into a picture.
//
// Cairo draws lines, surfaces and letters with smooth edges; the letters come from the project's own font files, so that a
// picture does not depend on the fonts of the machine.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>

#include "app/drawing/drawing.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::drawing {

class Painter {
public:
    /// The folder of DejaVuSans.ttf and DejaVuSans-Bold.ttf. Throws Error (badInput) when one is missing or no font.
    explicit Painter(const std::filesystem::path& fonts);
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    /// Over what the picture shows: the sheet's origin comes to `corner`, and each of its pixels becomes `scale` pixels wide.
    /// What reaches beyond the picture is cut off. Throws Error (bug) should Cairo fail.
    void paint(const Drawing& drawing, image::Image& picture, ivec2 corner = {0, 0}, double scale = 1) const;

private:
    struct Fonts;
    std::unique_ptr<Fonts> fonts_;
};

} // namespace shadowlab::drawing
