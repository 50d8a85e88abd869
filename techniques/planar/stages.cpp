// The intermediate pictures of planar shadows.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/read_back.h"
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

/// "0.45", without a sign; no more digits than a reader needs: three decimals of a direction, five digits of a distance.
std::string shortNumber(double value, int digits) {
    std::array<char, 32> text{};
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), std::abs(value), std::chars_format::general, digits);
    return error == std::errc{} ? std::string(text.data(), end) : "?";
}

std::string component(double value) {
    const double rounded = std::round(value * 1000) / 1000;
    return (rounded < 0 ? "-" : "") + shortNumber(rounded, 3);
}

} // namespace

std::string equation(const dvec4& plane) {
    constexpr double kNothing = 1e-12; // metres: rounding
    const double distance = std::abs(plane.w) < kNothing ? 0 : plane.w;
    return "(" + component(plane.x) + ", " + component(plane.y) + ", " + component(plane.z) + ")·P " +
           (distance < 0 ? "- " : "+ ") + shortNumber(distance, 5) + " = 0";
}

/// True if a stage shows the numbers of planes also where no shadow can fall.
bool Planar::showsTags(const Frame& frame) const {
    bool shows = frame.wants("stencil-tags") || frame.wants("receiver-planes");
    for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
        for (const char* stage : {"visibility", "shadow-marks", "points-in-shadow", "flattened"})
            shows = shows || frame.wants(stage, light);
    return shows;
}

/// Publishes how many casters and planes were left out.
void Planar::countLists(Frame& frame) const {
    frame.count("receivers", static_cast<double>(chosen_.size()), static_cast<double>(receivers_.all().size()),
                "planes");
    for (const std::vector<LitPlane>& planes : lit_)
        for (const LitPlane& plane : planes)
            frame.count("flattened", plane.casters, static_cast<double>(casters_.all().size()), "casters");
    for (const ChosenReceiver& one : chosen_) {
        const scene::Object& object = frame.scene().objects[one.receiver.object];
        frame.note(object.name, equation(planeOf(*one.receiver.face, scene::worldFromMesh(object))), colorOf(one));
    }
}

void Planar::publishVisibility(Frame& frame, int light) const {
    const bool sampled = isSampled(frame.scene().light(light));
    const gl::Program& program = sampled ? visibilityCounted_ : visibility_;
    frame.drawStage("visibility", light, GL_RG32F, [&] {
        // Every surface first, as if in shadow; then those without a mark.
        glDepthFunc(GL_EQUAL);
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
        gl::useForLight(visibility_, frame.scene(), frame.buffers(), frame.eye(), light);
        gl::drawSurfaces(visibility_, frame.scene(), frame.buffers(), frame.eye());
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl::setVisibilityState();
        drawLit(frame, program, light);
        clearBits(kLitBit);
        if (params_.once) return;
        glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
        darken(frame, light);
    });
}

/// Publishes the share of the picture in which planar shadows can be right. Only for measurements, which is when the
/// visibility stage is wanted.
void Planar::countServed(Frame& frame) const {
    bool wanted = false;
    for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
        wanted = wanted || frame.wants("visibility", light);
    if (!wanted) return;
    const std::vector<StencilPixel> stencil = readStencil(frame);
    const Region region = drawnRegion(frame.view());
    const int width = frame.view().size.x, bottom = frame.view().size.y - region.corner.y - region.size.y;
    double served = 0, surface = 0;
    for (int y = bottom; y < bottom + region.size.y; ++y)
        for (int x = region.corner.x; x < region.corner.x + region.size.x; ++x) {
            const StencilPixel& pixel = stencil[static_cast<std::size_t>(y * width + x)];
            surface += pixel.surface;
            served += pixel.surface && pixel.value != 0;
        }
    frame.count("served", served, surface, "pixels");
}

// The colour of a plane does not depend on the camera. The largest planes get the colours of Okabe and Ito, the others
// lighter and then darker ones.
vec3 Planar::colorOf(const ChosenReceiver& receiver) {
    static const std::array<vec3, 7> colors = {
        look::linearFromSrgb8(0x56, 0xB4, 0xE9), look::linearFromSrgb8(0xE6, 0x9F, 0x00),
        look::linearFromSrgb8(0x00, 0x9E, 0x73), look::linearFromSrgb8(0xF0, 0xE4, 0x42),
        look::linearFromSrgb8(0xCC, 0x79, 0xA7), look::linearFromSrgb8(0x00, 0x72, 0xB2),
        look::linearFromSrgb8(0xD5, 0x5E, 0x00)};
    const std::size_t rank = receiver.receiver.rank;
    const vec3 color = colors[rank % colors.size()];
    const std::size_t round = rank / colors.size() % 3;
    return round == 0 ? color : round == 1 ? glm::mix(color, vec3(1.0f), 0.5f) : 0.4f * color;
}

std::vector<KeyEntry> Planar::keyOf(const std::function<std::string(const ChosenReceiver&)>& named,
                                    const std::function<vec3(const ChosenReceiver&)>& colored) const {
    constexpr std::size_t kMostNamed = 6; // a legend that leaves room for the picture
    std::vector<KeyEntry> key;
    std::size_t others = 0;
    for (const ChosenReceiver& one : chosen_) { // largest first
        if (key.size() < kMostNamed)
            key.push_back({colored(one), named(one)});
        else
            ++others;
    }
    if (others > 0) key.push_back({look::kNoSurface, "and " + std::to_string(others) + " more"});
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
                         {.unit = "", .key = keyOf(named, [&](const ChosenReceiver& one) { return colorOf(one); })});
}

void Planar::publishTags(Frame& frame) const {
    std::array<vec3, kTagBits + 1> colors{};
    colors.fill(look::kNotAsked);
    for (auto one = chosen_.rbegin(); one != chosen_.rend(); ++one) // of planes that share a number the largest wins
        colors[static_cast<std::size_t>(one->tag)] = colorOf(*one);
    const auto colored = [&](const ChosenReceiver& one) { return colors[static_cast<std::size_t>(one.tag)]; };
    const auto named = [&](const ChosenReceiver& one) {
        return std::to_string(one.tag) + ": " + frame.scene().objects[one.receiver.object].name;
    };
    std::vector<KeyEntry> key = keyOf(named, colored);
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

void Planar::publishPoints(Frame& frame, int light) const {
    const std::vector<StencilPixel> stencil = readStencil(frame);
    const auto counted = counted_.find(light);
    std::vector<vec4> counts;
    if (counted != counted_.end()) counts = gl::readTexels(counted->second.counts);
    const ivec2 size = frame.target().size();
    std::vector<vec2> texels(stencil.size());
    for (std::size_t i = 0; i < stencil.size(); ++i) {
        const auto value = static_cast<unsigned>(stencil[i].value);
        if (!stencil[i].surface || (value & kTagBits) == 0) continue;
        // Texels come from the upper left, stencils from the lower left.
        const std::size_t x = i % static_cast<std::size_t>(size.x), y = i / static_cast<std::size_t>(size.x);
        const std::size_t fromAbove = (static_cast<std::size_t>(size.y) - 1 - y) * static_cast<std::size_t>(size.x) + x;
        texels[i] = vec2(counts.empty() ? float((value & kMarkBit) != 0) : counts[fromAbove].r, 1);
    }
    gl::Texture2D texture(GL_RG32F, size, "points-in-shadow");
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RG, GL_FLOAT, texels.data());
    const double most = counts.empty() ? 1.0 : static_cast<double>(counted->second.drawn);
    frame.publish("points-in-shadow", light, std::move(texture),
                  {.minimum = 0, .maximum = most, .unit = "points", .key = {}});
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
    PlanarParams all = params_;
    all.clip = all.cull = false;
    const scene::Light& source = frame.scene().light(light);
    const dvec4 lightWorld = scene::homogeneousPositionWorld(source);
    const std::vector<LitPlane> planes =
        litPlanes(frame.scene(), chosen_, casters_, frame.eye(), lightWorld, source, all, false);
    const auto shown = std::ranges::find(planes, tag, [](const LitPlane& plane) { return plane.receiver->tag; });
    const auto draw = [&] {
        if (shown == planes.end()) return; // no plane is lit, or nothing falls on one
        glDepthFunc(GL_LEQUAL);
        glDepthMask(GL_FALSE);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0, -kNearer);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        const auto paint = [&](const vec3& color, Part part) {
            setColor(paintFlattened_, *shown, unexposed(frame, color, kAlpha));
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
