// The intermediate pictures of planar shadows.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "techniques/foundation/look.h"
#include "techniques/planar/technique.h"

namespace shadowlab::planar {

namespace {

/// A display colour as the radiance that exposure turns into it.
vec4 unexposed(const Frame& frame, const vec3& color, float alpha) { return {color / frame.scene().exposure, alpha}; }

struct StencilPixel {
    int value = 0;
    bool surface = false;
};

/// The target's stencil, rows as OpenGL has them. Depth and stencil of a pixel come as one word: 24 bits of depth first.
std::vector<StencilPixel> readStencil(const Frame& frame) {
    const ivec2 size = frame.target().size();
    std::vector<std::uint32_t> words(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.target().framebuffer.id());
    glReadPixels(0, 0, size.x, size.y, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, words.data());
    std::vector<StencilPixel> pixels;
    pixels.reserve(words.size());
    for (const std::uint32_t word : words)
        pixels.push_back({static_cast<int>(word & 0xff), (word >> 8) < 0xffffff});
    return pixels;
}

/// Publishes a colour for each pixel's stencil value, where there is a surface.
void publishColors(Frame& frame, std::string_view stage, int light, std::vector<KeyEntry> key,
                   const auto& colorOfValue) {
    std::vector<vec4> colors;
    for (const StencilPixel& pixel : readStencil(frame))
        colors.emplace_back(pixel.surface ? colorOfValue(pixel.value) : look::kNoSurface, 1.0f);
    const ivec2 size = frame.target().size();
    gl::Texture2D texture(GL_RGBA16F, size, stage);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, colors.data());
    frame.publish(stage, light, std::move(texture), {.unit = "", .key = std::move(key)});
}

/// "0.45", without a sign; no more digits than a reader needs.
std::string shortNumber(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", std::round(std::abs(value) * 1000) / 1000);
    return text.data();
}

std::string signedNumber(double value) { return (value <= -0.0005 ? "-" : "") + shortNumber(value); }

} // namespace

std::string equation(const dvec4& plane) {
    return "(" + signedNumber(plane.x) + ", " + signedNumber(plane.y) + ", " + signedNumber(plane.z) + ")·P " +
           (plane.w <= -0.0005 ? "- " : "+ ") + shortNumber(plane.w) + " = 0";
}

void Planar::publishVisibility(Frame& frame, int light) const {
    frame.drawStage("visibility", light, GL_RG32F, [&] {
        // Every surface first, as if in shadow; then those without a mark.
        glDepthFunc(GL_EQUAL);
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
        visibility_.use();
        gl::drawSurfaces(visibility_, frame.scene(), frame.buffers(), frame.eye());
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl::setVisibilityState();
        drawUnmarked(frame, visibility_, light);
    });
}

/// How much of the picture can be right: asked for when somebody measures, which is when visibility is wanted.
void Planar::countServed(Frame& frame) const {
    bool wanted = false;
    for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
        wanted = wanted || frame.wants("visibility", light);
    if (!wanted) return;
    double served = 0, surface = 0;
    for (const StencilPixel& pixel : readStencil(frame)) {
        surface += pixel.surface;
        served += pixel.surface && pixel.value != 0;
    }
    frame.count("served", served, surface, "pixels");
}

// The same plane keeps its colour wherever the camera goes: Okabe and Ito's colours, then lighter, then darker ones.
vec3 Planar::colorOf(const ChosenReceiver& receiver) const {
    static const std::array<vec3, 7> colors = {
        look::linearFromSrgb8(0x56, 0xB4, 0xE9), look::linearFromSrgb8(0xE6, 0x9F, 0x00),
        look::linearFromSrgb8(0x00, 0x9E, 0x73), look::linearFromSrgb8(0xF0, 0xE4, 0x42),
        look::linearFromSrgb8(0xCC, 0x79, 0xA7), look::linearFromSrgb8(0x00, 0x72, 0xB2),
        look::linearFromSrgb8(0xD5, 0x5E, 0x00)};
    std::size_t index = 0;
    while (receivers_.all()[index].object != receiver.receiver.object ||
           receivers_.all()[index].face != receiver.receiver.face)
        ++index;
    const vec3 color = colors[index % colors.size()];
    const std::size_t round = index / colors.size() % 3;
    return round == 0 ? color : round == 1 ? glm::mix(color, vec3(1.0f), 0.5f) : 0.4f * color;
}

std::vector<KeyEntry> Planar::keyOf(const std::function<std::string(const ChosenReceiver&)>& named) const {
    constexpr std::size_t kMostNamed = 6; // a legend that leaves room for the picture
    std::vector<KeyEntry> key;
    for (const ChosenReceiver& one : chosen_) { // largest first
        if (key.size() == kMostNamed) {
            key.push_back({look::kNoSurface, "and " + std::to_string(chosen_.size() - kMostNamed) + " smaller ones"});
            break;
        }
        key.push_back({colorOf(one), named(one)});
    }
    return key;
}

void Planar::publishPlanes(Frame& frame) const {
    constexpr float kAlpha = 0.6f; // what lies on the plane stays recognisable
    const auto named = [&](const ChosenReceiver& one) {
        const scene::Object& object = frame.scene().objects[one.receiver.object];
        return object.name + ": " + equation(planeOf(*one.receiver.face, scene::worldFromMesh(object)));
    };
    frame.drawOverTarget("receiver-planes", kNoLight, true,
                         [&] {
                             glDepthFunc(GL_EQUAL);
                             glDepthMask(GL_FALSE);
                             glEnable(GL_STENCIL_TEST);
                             glEnable(GL_BLEND);
                             glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                             paintPlane_.use();
                             for (const ChosenReceiver& one : chosen_) {
                                 glStencilFunc(GL_EQUAL, one.tag, kTagBits);
                                 paintPlane_.set("color", unexposed(frame, colorOf(one), kAlpha));
                                 drawReceiver(frame, paintPlane_, one);
                             }
                         },
                         {.unit = "", .key = keyOf(named)});
}

void Planar::publishTags(Frame& frame) const {
    std::array<vec3, kTagBits + 1> colors{};
    colors.fill(look::kNotAsked);
    for (const ChosenReceiver& one : chosen_)
        colors[static_cast<std::size_t>(one.tag)] = colorOf(one);
    const auto named = [&](const ChosenReceiver& one) {
        return std::to_string(one.tag) + ": " + frame.scene().objects[one.receiver.object].name;
    };
    std::vector<KeyEntry> key = keyOf(named);
    key.push_back({look::kNotAsked, "0: no plane"});
    publishColors(frame, "stencil-tags", kNoLight, std::move(key),
                  [&](int value) { return colors[static_cast<std::size_t>(value)]; });
}

void Planar::publishMarks(Frame& frame, int light) const {
    publishColors(frame, "shadow-marks", light,
                  {{look::kEqualDepth, "on a plane, not marked"},
                   {look::kOccluded, "marked: in shadow"},
                   {look::kNotAsked, "no receiver plane: no shadow can fall here"}},
                  [](int value) {
                      const bool marked = (static_cast<unsigned>(value) & kMarkBit) != 0;
                      return marked ? look::kOccluded : value != 0 ? look::kEqualDepth : look::kNotAsked;
                  });
}

int Planar::mostMarkedTag(const Frame& frame) {
    std::array<int, kTagBits + 1> marked{};
    for (const StencilPixel& pixel : readStencil(frame))
        if ((static_cast<unsigned>(pixel.value) & kMarkBit) != 0)
            ++marked[static_cast<unsigned>(pixel.value) & kTagBits];
    return static_cast<int>(std::ranges::max_element(marked) - marked.begin());
}

void Planar::publishFlattened(Frame& frame, int light, int tag) const {
    constexpr float kAlpha = 0.45f; // the layers of a closed caster, front and back, stay distinguishable
    constexpr float kNearer = 16;   // steps of depth: the plane itself does not hide them, what stands before it does
    const vec3 between = look::kOccluded, beyond = look::kMultipleEdge, behind = look::kAwayFromLight;
    const std::vector<PlaneOfLight> planes = planesOf(frame, light, false);
    const auto shown = std::ranges::find(planes, tag, [](const PlaneOfLight& plane) { return plane.receiver->tag; });
    const auto draw = [&] {
        if (shown == planes.end()) return; // no plane is lit, or nothing falls on one
        glDepthFunc(GL_LEQUAL);
        glDepthMask(GL_FALSE);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0, -kNearer);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        paintFlattened_.use();
        const auto paint = [&](const vec3& color, Part part) {
            paintFlattened_.set("color", unexposed(frame, color, kAlpha));
            drawFlattened(frame, paintFlattened_, *shown, part);
        };
        paint(behind, Part::behindPlane);
        paint(beyond, Part::beyondLight);
        paint(between, Part::between);
    };
    frame.drawOverTarget("flattened", light, true, draw,
                         {.unit = "",
                          .key = {{between, "from between light and plane: the shadow"},
                                  {beyond, "from beyond the light: an anti-shadow"},
                                  {behind, "from behind the plane"}}});
}

} // namespace shadowlab::planar
