// Planar projected shadows: every caster is flattened onto every plane that it may shadow, away from the light.
//
// Blinn, "Me and My (Fake) Shadow", 1988. What makes it exact on planes: casters are clipped where they pass the light or
// the plane, and the flattened faces are drawn without depth, only where the stencil says that this very plane is seen. So
// nothing spills over the plane's edge, nothing fights for depth, and overlapping casters darken once.
// Simplified: a light with an area is its centre; curved surfaces receive nothing.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/planar/casters.h"
#include "techniques/planar/projection.h"
#include "techniques/planar/receivers.h"

namespace shadowlab::planar {

struct PlanarParams {
    int receivers = kMostReceivers;
    bool clip = true;
    bool stencil = true;
    double offset = 4;
    bool cull = true;
};

/// A caster on its way to one plane.
struct FlattenedCaster {
    const Caster* caster = nullptr;
    dmat4 viewFromMesh{1.0};
    double contact = 0; ///< metres; see contactHeight
};

/// One plane that one light shines on, and what is flattened onto it.
struct PlaneOfLight {
    const ChosenReceiver* receiver = nullptr;
    Projection projection;
    std::vector<FlattenedCaster> casters;
};

// The stencil's eight bits: the plane's number, "lit already" (two surfaces at one depth must not both add their light),
// and the shadow mark.
constexpr unsigned kTagBits = 0x3f, kLitBit = 0x40, kMarkBit = 0x80;
static_assert(kMostReceivers == static_cast<int>(kTagBits));

class Planar final : public Technique {
public:
    params::ParamList params() override;
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override;
    Progress render(Frame& frame) override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot& snapshot, const View& view, int light) override;
    std::string remark(const scene::MeshReport& report) const override;

private:
    /// Which part of the casters is drawn, by where it is; `wherever`: all of it, clipped by nothing. Beyond the light
    /// points have a negative weight: the card shows them only with all signs turned over.
    enum class Part { between, beyondLight, behindPlane, wherever, whereverTurnedOver };

    [[nodiscard]] std::vector<PlaneOfLight> planesOf(const Frame& frame, int light, bool cull) const;
    void tagReceivers(const Frame& frame);
    static void drawReceiver(const Frame& frame, const gl::Program& program, const ChosenReceiver& one);
    void markShadows(const Frame& frame, const std::vector<PlaneOfLight>& planes) const;
    void drawFlattened(const Frame& frame, const gl::Program& program, const PlaneOfLight& plane, Part part) const;
    void drawUnmarked(const Frame& frame, const gl::Program& program, int light) const;

    // stages.cpp
    void publishVisibility(Frame& frame, int light) const;
    void publishPlanes(Frame& frame) const;
    void publishTags(Frame& frame) const;
    void publishMarks(Frame& frame, int light) const;
    [[nodiscard]] static int mostMarkedTag(const Frame& frame);
    void publishFlattened(Frame& frame, int light, int tag) const;
    [[nodiscard]] std::vector<KeyEntry> keyOf(const std::function<std::string(const ChosenReceiver&)>& named) const;
    [[nodiscard]] vec3 colorOf(const ChosenReceiver& receiver) const;
    void countServed(Frame& frame) const;

    PlanarParams params_;
    Receivers receivers_;
    Casters casters_;
    std::vector<ChosenReceiver> chosen_; ///< for the frame that is being drawn
    gl::Program lightsOff_{"surface.vert", "lights_off.frag"};
    gl::Program shade_{"surface.vert", "shade_light.frag"};
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
    gl::Program tag_{"position.vert", "nothing.frag"};
    gl::Program flatten_{"planar/flatten.vert", "nothing.frag"};
    gl::Program paintPlane_{"position.vert", "constant.frag"};
    gl::Program paintFlattened_{"planar/flatten.vert", "constant.frag"};
};

/// "(0, 1, 0)·P - 0.45 = 0"
std::string equation(const dvec4& plane);

} // namespace shadowlab::planar
