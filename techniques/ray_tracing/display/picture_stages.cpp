// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/display/stages.h"

#include <algorithm>

#include "techniques/foundation/base/look.h"
#include "techniques/ray_tracing/described.h"
#include "techniques/ray_tracing/display/upload.h"

namespace shadowlab::ray_tracing {

namespace {

/// The share of the light that a pixel sees: of its area, or 0 or 1 by what its centre says.
float seenShare(const Picture& picture, int light, const LightShares* shares, std::size_t pixel) {
    if (shares) return shares->shares()[pixel];
    return picture.visibility(light)[pixel] == trace::Visibility::lit ? 1.0f : 0.0f;
}

/// Distances from the eye.
void publishDistances(Frame& frame, const trace::SceneTracer& tracer, const Picture& picture) {
    Display display{.minimum = 0, .maximum = 1, .unit = "m from the eye", .key = {}};
    // One pixel in fifty may lie beyond each end of the scale; otherwise a distant horizon would leave one colour for everything
    // near.
    const trace::EyeRays rays = tracer.eyeRays(frame.view().camera, frame.view().size);
    std::vector<double> distances;
    for (const trace::SurfacePoint& point : picture.points())
        if (point) distances.push_back(tracer.distance(rays, point));
    if (!distances.empty()) {
        std::ranges::sort(distances);
        display.minimum = distances[distances.size() / 50];
        display.maximum = std::max(distances[distances.size() - 1 - distances.size() / 50],
                                   display.minimum + 1e-3 * distances.back());
    }
    gl::Texture2D texture(GL_RG32F, picture.size(), "primary-hits");
    upload(texture, picture.points(), picture.size(), [&](const trace::SurfacePoint& point) {
        return point ? vec2(static_cast<float>(tracer.distance(rays, point)), 1.0f) : vec2(0.0f);
    });
    frame.publish("primary-hits", kNoLight, std::move(texture), display);
}

/// The results of the shadow rays to a light.
void publishShadowRays(Frame& frame, const Picture& picture, int light) {
    const Display display{.unit = "",
                          .key = {{look::kEqualDepth, "the ray arrives: lit"},
                                  {look::kOccluded, "something is in its way: in shadow"},
                                  {look::kNotAsked, "faces away or outside the light: no ray sent"}}};
    gl::Texture2D texture(GL_RGBA16F, picture.size(), "shadow-rays");
    const vec3 background = frame.scene().background;
    upload(texture, picture.visibility(light), picture.size(), [&](trace::Visibility visibility) {
        using enum trace::Visibility;
        switch (visibility) {
        case noSurface: return vec4(background, 1.0f);
        case turnedAway: return vec4(look::kNotAsked, 1.0f);
        case shadowed: return vec4(look::kOccluded, 1.0f);
        case lit: return vec4(look::kEqualDepth, 1.0f);
        }
        return vec4(0.0f);
    });
    frame.publish("shadow-rays", light, std::move(texture), display);
}

/// The visibility that every technique publishes. `shares`: the visible share of the light's area, where it was computed; else
/// nullptr.
void publishVisibility(Frame& frame, const Picture& picture, int light, const LightShares* shares) {
    const Grid<trace::Visibility>& fromCentre = picture.visibility(light);
    Grid<vec2> texels(fromCentre.size());
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const float seen = seenShare(picture, light, shares, i);
        texels[i] = vec2(seen, fromCentre[i] == trace::Visibility::noSurface ? 0.0f : 1.0f);
    }
    gl::Texture2D texture(GL_RG32F, picture.size(), "visibility");
    upload(texture, texels, picture.size(), [](vec2 texel) { return texel; });
    frame.publish("visibility", light, std::move(texture));
}

/// Lit, penumbra and umbra: where all, a part, or nothing of the light is seen.
void publishPenumbra(Frame& frame, const Picture& picture, int light, const LightShares* shares) {
    const Display display{.unit = "",
                          .key = {{look::kEqualDepth, "lit: all of the light is seen"},
                                  {look::kPartlySeen, "penumbra: a part of it"},
                                  {look::kOccluded, "umbra: nothing of it"},
                                  {look::kNotAsked, "faces away or outside the light"}}};
    const Grid<trace::Visibility>& fromCentre = picture.visibility(light);
    Grid<vec4> texels(fromCentre.size(), vec4(0.0f)); // no value
    const bool isKnown = !shares || shares->isComplete();
    for (std::size_t i = 0; isKnown && i < texels.size(); ++i) {
        using enum trace::Visibility;
        const float seen = seenShare(picture, light, shares, i);
        const vec3 color = fromCentre[i] == noSurface    ? frame.scene().background
                           : fromCentre[i] == turnedAway ? look::kNotAsked
                           : seen <= 0                   ? look::kOccluded
                           : seen >= 1                   ? look::kEqualDepth
                                                         : look::kPartlySeen;
        texels[i] = vec4(color, 1.0f);
    }
    gl::Texture2D texture(GL_RGBA16F, picture.size(), "penumbra");
    upload(texture, texels, picture.size(), [](const vec4& texel) { return texel; });
    frame.publish("penumbra", light, std::move(texture), display);
}

/// How many samples each pixel has.
void publishSamples(Frame& frame, const Picture& picture, const SampledPicture& sampled) {
    std::vector<std::uint32_t> counts = sampled.samples();
    if (counts.empty()) counts.assign(picture.points().size(), 1); // one ray through the middle of each pixel
    const double most = *std::ranges::max_element(counts);
    gl::Texture2D texture(GL_RG32F, picture.size(), "samples-per-pixel");
    upload(texture, counts, picture.size(),
           [](std::uint32_t count) { return vec2(static_cast<float>(count), count > 0 ? 1.0f : 0.0f); });
    frame.publish("samples-per-pixel", kNoLight, std::move(texture),
                  {.minimum = 0, .maximum = std::max(1.0, most), .unit = "samples", .key = {}});
}

/// What reflection or refraction rays add; black where no tree was traced.
void publishAdded(Frame& frame, std::string_view stage, const Picture& picture, const Grid<vec3>& addedFromBelow) {
    gl::Texture2D texture(GL_RGBA16F, picture.size(), stage);
    const Grid<vec3> nothing(addedFromBelow.empty() ? picture.points().size() : 0, vec3(0.0f));
    uploadFromBelow(texture, addedFromBelow.empty() ? nothing : addedFromBelow, picture.size());
    frame.publish(stage, kNoLight, std::move(texture));
}

/// The number of levels of each pixel's tree.
void publishLevels(Frame& frame, const Picture& picture) {
    Grid<vec2> levels(picture.points().size());
    int most = 2; // a scale needs two ends
    for (std::size_t i = 0; i < levels.size(); ++i) {
        levels[i] = vec2(static_cast<float>(picture.levels(i)), picture.points()[i] ? 1.0f : 0.0f);
        most = std::max(most, picture.levels(i));
    }
    gl::Texture2D texture(GL_RG32F, picture.size(), "tree-depth");
    upload(texture, levels, picture.size(), [](vec2 texel) { return texel; });
    frame.publish("tree-depth", kNoLight, std::move(texture),
                  {.minimum = 1, .maximum = static_cast<double>(most), .unit = "levels of rays", .key = {}});
}

} // namespace

RayCounts countRays(const trace::SceneTracer& tracer, const Picture& picture) {
    using enum trace::Visibility;
    const Grid<trace::SurfacePoint>& points = picture.points();
    RayCounts counts;
    const bool allReceive = std::ranges::all_of(tracer.scene().objects, &scene::Object::receivesShadow);
    for (int light = 0; light < static_cast<int>(tracer.scene().lights.size()); ++light) {
        // Bytes, one pixel's after another: read much quicker than the points.
        const Grid<trace::Visibility>& seen = picture.visibility(light);
        const auto count = [&](const auto& isOne) { return static_cast<std::size_t>(std::ranges::count_if(seen, isOne)); };
        if (light == 0) counts.hits = count([](trace::Visibility one) { return one != noSurface; });
        RayCounts::OfLight& ofLight = counts.shadowRays.emplace_back();
        ofLight.blocked = count([](trace::Visibility one) { return one == shadowed; });
        ofLight.asked = count([](trace::Visibility one) { return one >= shadowed; });
        for (std::size_t i = 0; !allReceive && i < points.size(); ++i)
            if (seen[i] >= shadowed && !tracer.objectOf(points[i]).receivesShadow) --ofLight.asked;
    }
    if (counts.shadowRays.empty())
        counts.hits = static_cast<std::size_t>(std::ranges::count_if(points, [](const trace::SurfacePoint& point) { return bool(point); }));
    return counts;
}

void publishCounts(Frame& frame, const RayCounts& counts) {
    const ivec2 size = frame.view().size;
    frame.count("eye-rays", static_cast<double>(counts.hits), static_cast<double>(size.x) * size.y, "hits");
    for (const RayCounts::OfLight& ofLight : counts.shadowRays)
        frame.count("shadow-rays", static_cast<double>(ofLight.blocked), static_cast<double>(ofLight.asked), "blocked");
}

void publishStages(Frame& frame, const StageSources& sources) {
    const auto& [tracer, structures, picture, sampled, allShares] = sources;
    if (frame.wants("primary-hits")) publishDistances(frame, tracer, picture);
    for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
        const auto shares = allShares.find(light);
        if (frame.wants("shadow-rays", light)) publishShadowRays(frame, picture, light);
        if (frame.wants("visibility", light))
            publishVisibility(frame, picture, light, shares == allShares.end() ? nullptr : &shares->second);
        if (frame.wants("penumbra", light))
            publishPenumbra(frame, picture, light, shares == allShares.end() ? nullptr : &shares->second);
    }
    if (frame.wants("reflected")) publishAdded(frame, "reflected", picture, picture.reflectedFromBelow());
    if (frame.wants("transmitted")) publishAdded(frame, "transmitted", picture, picture.transmittedFromBelow());
    if (frame.wants("tree-depth")) publishLevels(frame, picture);
    if (frame.wants("samples-per-pixel")) publishSamples(frame, picture, sampled);
    if (frame.wants(kTestsStage.id)) publishTests(frame, tracer, structures);
    if (frame.wants(kStructureStage.id)) publishStructure(frame, tracer, structures, picture);
}

} // namespace shadowlab::ray_tracing
