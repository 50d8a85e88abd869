// The two ways to count the faces of shadow volumes into the stencil, and what they draw.
//
// Depth pass counts what lies before each visible point, depth fail what lies behind it. Both may be used in one picture,
// each for some casters: the counts add up.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/cull/volume_in_view.h"

namespace shadowlab::shadow_volume {

/// A volume that is drawn, and how it is counted.
struct CountedVolume {
    VolumeInView seen;
    CountMethod method = CountMethod::zFail;
    const VolumeBuffers* extruded = nullptr; ///< what the processor has extruded; null: the vertex shader does
};

struct PassRule {
    /// The eye may be in a volume: the count starts with the number of volumes around it (eye_line.h), the near plane cuts
    /// nothing off, and the parts of top caps before the near plane count as well.
    bool corrected = false;
    friend bool operator==(const PassRule&, const PassRule&) = default;
};

struct FailRule {
    bool caps = true;
    bool clamp = true;        ///< depth, for what lies beyond the far plane
    bool lessOrEqual = false; ///< depth test of the faces
    bool farPlane = false;    ///< there is one, just beyond the scene
    friend bool operator==(const FailRule&, const FailRule&) = default;
};

/// Size of the counter, and what it does beyond its range: it wraps around, or it saturates.
struct StencilRule {
    int bits = 8; ///< of it that are used
    bool wrap = true;
    [[nodiscard]] GLuint mask() const { return (1u << bits) - 1u; }
    friend bool operator==(const StencilRule&, const StencilRule&) = default;
};

/// What a count is made of.
struct CountRules {
    PassRule pass;
    FailRule fail;
    friend bool operator==(const CountRules&, const CountRules&) = default;
};

class FaceCounter {
public:
    /// Counts the faces of volumes into the stencil, each volume by its method. The stencil test is on, depth is not
    /// written, and one side may be culled.
    void countIntoStencil(const Frame& frame, int light, std::span<const CountedVolume> volumes,
                          const CountRules& rules, const StencilRule& stencil) const;

    /// The same into the bound colour, blended: +1 and -1 as floats (float_count.h); `allAdd`: +1 for every face.
    void countIntoColor(const Frame& frame, int light, std::span<const CountedVolume> volumes, const CountRules& rules,
                        bool allAdd) const;

private:
    /// A program for each kind of face, all with the same fragment shader.
    struct Programs {
        explicit Programs(const std::string& fragment);
        gl::Program extrude, extruded, cap, nearCap;
    };
    void drawPassing(const Frame& frame, int light, std::span<const CountedVolume> volumes, const PassRule& rule,
                     const Programs& programs) const;
    void drawFailing(const Frame& frame, int light, std::span<const CountedVolume> volumes, const FailRule& rule,
                     const Programs& programs) const;
    /// Sides, bottom cap or both.
    void drawExtruded(const Frame& frame, const CountedVolume& volume, int light, bool bottomCap,
                      const Programs& programs) const;
    void drawTopCap(const Frame& frame, const gl::Program& program, const CasterVolume& caster) const;

    Programs forStencil_{"nothing.frag"};
    Programs forColor_{"shadow_volume/count.frag"};
};

} // namespace shadowlab::shadow_volume
