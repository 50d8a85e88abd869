// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/finished_picture.h"

#include <algorithm>

#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::ray_tracing {

namespace {

/// srgbFromLinear() from a table: a power for each channel of each pixel would take longer than the shading.
class Encoding {
public:
    explicit Encoding(float exposure) : exposure_(exposure) {}
    [[nodiscard]] image::Color8 operator()(const vec3& radiance) const {
        return {level(radiance.r), level(radiance.g), level(radiance.b), 255};
    }

private:
    // In the steepest part of the curve, 12.92 c, neighbouring entries are a twentieth of a level apart.
    static constexpr int kLast = 65535;
    static const std::vector<std::uint8_t>& table() {
        static const std::vector<std::uint8_t> levels = [] {
            std::vector<std::uint8_t> made(kLast + 1);
            for (int i = 0; i <= kLast; ++i)
                made[static_cast<std::size_t>(i)] = image::srgbFromLinear(static_cast<float>(i) / kLast);
            return made;
        }();
        return levels;
    }
    [[nodiscard]] std::uint8_t level(float linear) const {
        return levels_[static_cast<std::size_t>(std::clamp(exposure_ * linear, 0.0f, 1.0f) * kLast + 0.5f)];
    }
    float exposure_;
    const std::uint8_t* levels_ = table().data();
};

/// What shading needs of a light, relative to the centre of the traced scene.
struct CentredLight {
    const scene::Light* source;
    const Grid<trace::Visibility>* visibility;
    dvec3 positionCentred;
    vec3 intensity; ///< per colour
    bool isDirectional;
};

std::vector<CentredLight> centredLights(const Surfaces& surfaces, const Picture& traced) {
    std::vector<CentredLight> lights;
    for (int i = 0; i < static_cast<int>(surfaces.scene().lights.size()); ++i) {
        const scene::Light& light = surfaces.scene().light(i);
        lights.push_back({&light, &traced.visibility(i), light.positionWorld - surfaces.tracer().world().originWorld,
                          vec3(dvec3(light.color) * scene::pointIntensity(light)),
                          light.type == scene::LightType::directional});
    }
    return lights;
}

} // namespace

void FinishedPicture::encode(const Grid<vec3>& radiance, float exposure) {
    colors_.resize(radiance.size());
    constexpr std::size_t kRun = 8192; // pixels for a thread at a time
    trace::parallelFor((radiance.size() + kRun - 1) / kRun, [&, encoding = Encoding(exposure)](std::size_t run) {
        for (std::size_t i = run * kRun; i < std::min(radiance.size(), (run + 1) * kRun); ++i)
            colors_[i] = encoding(radiance[i]);
    });
}

void FinishedPicture::shade(const Surfaces& surfaces, const Picture& traced) {
    const trace::SceneTracer& tracer = surfaces.tracer();
    const std::vector<CentredLight> lights = centredLights(surfaces, traced);
    const dvec3 eyeCentred = traced.camera().positionWorld - tracer.world().originWorld;
    const auto width = static_cast<std::size_t>(traced.size().x), height = static_cast<std::size_t>(traced.size().y);
    const Encoding encoding(surfaces.scene().exposure);
    const image::Color8 background = encoding(surfaces.scene().background);
    const auto colorOf = [&](std::size_t pixel) {
        const PixelHit& hit = traced.points()[pixel];
        if (!hit) return background;
        const trace::SurfacePoint point = hit.surfacePoint();
        vec3 radiance = surfaces.lightsOff(point);
        const auto isLitBy = [&](const CentredLight& light) { return (*light.visibility)[pixel] == trace::Visibility::lit; };
        if (std::ranges::none_of(lights, isLitBy)) return encoding(radiance);
        // Differences in double, so that nothing is lost in a scene that is large or far from its origin.
        const dvec3 positionCentred = tracer.positionCentred(point);
        const vec3 toEyeWorld = glm::normalize(vec3(eyeCentred - positionCentred));
        const vec3 normalWorld = surfaces.normalWorld(point, toEyeWorld);
        for (const CentredLight& light : lights) {
            if (!isLitBy(light)) continue;
            const vec3 offset(light.positionCentred - positionCentred);
            const vec3 toLightWorld = light.isDirectional ? vec3(-light.source->directionWorld) : glm::normalize(offset);
            const float left = scene::falloff(*light.source, normalWorld, toLightWorld, glm::dot(offset, offset));
            if (left > 0)
                radiance += left * light.intensity *
                            scene::reflectance(surfaces.materialOf(point), normalWorld, toLightWorld, toEyeWorld);
        }
        return encoding(radiance);
    };
    colors_.resize(width * height);
    trace::parallelFor(height, [&](std::size_t y) {
        for (std::size_t x = 0; x < width; ++x)
            colors_[(height - 1 - y) * width + x] = colorOf(y * width + x);
    });
}

} // namespace shadowlab::ray_tracing
