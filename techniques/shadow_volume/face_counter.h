// The two ways to count the faces of shadow volumes into the stencil, and what they draw.
//
// Depth pass counts what lies before each visible point, depth fail what lies behind it. Both may be used in one picture,
// each for some casters: the counts add up.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/shadow_volume/volume_in_view.h"

namespace shadowlab::shadow_volume {

enum class Way { pass, fail };

/// A volume that is drawn, and how it is counted.
struct CountedVolume {
    VolumeInView seen;
    Way way = Way::fail;
    const VolumeBuffers* extruded = nullptr; ///< what the processor has extruded; null: the vertex shader does
};

struct PassRule {
    /// The walk may start in a volume: it starts with the eye's own count (eye_line.h), nothing is cut off at the near
    /// plane, and the top caps that lie before it count as well.
    bool corrected = false;
};

struct FailRule {
    bool caps = true;
    bool clamp = true;        ///< depth, for what lies beyond the far plane
    bool lessOrEqual = false; ///< depth test of the faces
};

/// How the counter behaves at its ends: it wraps around, or it sticks there.
struct StencilRule {
    int bits = 8; ///< of it that are used
    bool wrap = true;
    [[nodiscard]] GLuint mask() const { return (1u << bits) - 1u; }
};

class FaceCounter {
public:
    /// Draws the faces of the volumes that are counted that way. The stencil test is on, colour and depth are not
    /// written, and one side may be culled.
    void countPassing(const Frame& frame, int light, std::span<const CountedVolume> volumes, const PassRule& rule,
                      const StencilRule& stencil) const;
    void countFailing(const Frame& frame, int light, std::span<const CountedVolume> volumes, const FailRule& rule,
                      const StencilRule& stencil) const;

private:
    /// Sides, bottom cap or both.
    void drawExtruded(const Frame& frame, const CountedVolume& volume, int light, bool bottomCap) const;
    void drawTopCap(const Frame& frame, const gl::Program& program, const CasterVolume& caster) const;

    gl::Program extrude_{"shadow_volume/extrude.vert", "nothing.frag"};
    gl::Program extruded_{"shadow_volume/extruded.vert", "nothing.frag"};
    gl::Program cap_{"position.vert", "nothing.frag"};
    gl::Program nearCap_{"shadow_volume/near_cap.vert", "nothing.frag"};
};

} // namespace shadowlab::shadow_volume
