// Drawing the receivers with a light's map: the programs that look it up, and which objects need to look at all.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>

#include "techniques/shadow_map/maps/map_drawer.h"
#include "techniques/shadow_map/receiver_uniforms.h"

namespace shadowlab::shadow_map {

constexpr int kDecidedUnit = kMapUnit + 5, kMomentsUnit = kMapUnit + 6;

/// Uniforms of one program beside those that all lookups have.
struct OwnUniforms {
    std::function<void(const gl::Program&)> once{};                          ///< set once the program is in use
    std::function<void(const gl::Program&, std::size_t object)> perObject{}; ///< and before each object
    gl::ShadedAs shadedAs = gl::ShadedAs::radiance;
};

class Receivers {
public:
    Receivers(const ShadowMapParams& params, MapFitter& fitter) : params_(params), fitter_(fitter) {}

    /// Put together of one GLSL file for each choice: where the map is looked up, which bias, which filter.
    struct Programs {
        gl::Program shade, visibility, project, texelSize, layers, penumbra, kernel, decide;
    };
    const Programs& programsFor(const LightShadowMap& map);
    /// The program that adds the light where the map lets it through, or only writes how much that is.
    const gl::Program& lightProgram(const LightShadowMap& map, bool visibilityOnly);
    /// The same without any shadows.
    [[nodiscard]] const gl::Program& unshadowed(bool visibilityOnly) const {
        return visibilityOnly ? unshadowedVisibility_ : unshadowed_;
    }

    /// Draws all receivers with the program.
    void draw(const Frame& frame, const gl::Program& program, int light, const LightShadowMap& map,
              const OwnUniforms& own = {});
    /// Draws them with `lookup` where a caster's shadow can fall, and with `plain` elsewhere.
    void drawWhereNeeded(const Frame& frame, const gl::Program& lookup, const gl::Program& plain, int light,
                         const LightShadowMap& map, const OwnUniforms& own = {});
    /// Draws the light as its map lets it through, or only how much that is.
    void drawLight(const Frame& frame, int light, const LightShadowMap& map, gl::ShadedAs shadedAs) {
        drawWhereNeeded(frame, lightProgram(map, false), unshadowed(false), light, map, {.shadedAs = shadedAs});
    }
    void drawVisibility(const Frame& frame, int light, const LightShadowMap& map) {
        drawWhereNeeded(frame, lightProgram(map, true), unshadowed(true), light, map);
    }

private:
    struct Choice {
        Layout layout;
        BiasMode bias;
        FilterKind filter;
        bool inWorld; ///< see ShadowMapParams::looksUpInWorld
        friend auto operator<=>(const Choice&, const Choice&) = default;
    };
    static Programs makePrograms(const Choice& choice);
    void use(const Frame& frame, const gl::Program& program, int light, const LightShadowMap& map,
             const OwnUniforms& own) const;
    void setObject(const Frame& frame, const gl::Program& program, const LightShadowMap& map, std::size_t object,
                   const OwnUniforms& own) const;

    inline static const std::vector<gl::Substitution> kDecided{{"shadow_visibility.glsl", "shadow_map/decided.glsl"}};
    const ShadowMapParams& params_;
    MapFitter& fitter_;
    std::map<Choice, Programs> programs_;
    gl::Program unshadowed_{"surface.vert", "shade_light.frag"};
    gl::Program unshadowedVisibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
    gl::Program decidedShade_{"surface.vert", "shade_light.frag", {}, kDecided};
    gl::Program decidedVisibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}, kDecided};
};

} // namespace shadowlab::shadow_map
