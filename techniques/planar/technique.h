// Planar projected shadows: every caster is flattened onto every plane that it may shadow, away from the light.
//
// Blinn, "Me and My (Fake) Shadow", 1988. What makes it exact on planes: casters are clipped where they pass the light or
// the plane, and the flattened faces are drawn without depth, only where the stencil says that this very plane is seen. So
// nothing spills over the plane's edge, nothing fights for depth, and overlapping casters darken once. A light with an area
// casts one such shadow from each of many of its points, and they are counted (Heckbert and Herf, "Simulating Soft Shadows with
// Graphics Hardware", CMU-CS-97-104, 1997).
// Simplified: curved surfaces receive nothing.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/planar/flattening.h"
#include "techniques/shading_passes.h"

namespace shadowlab::planar {

// The stencil's eight bits: the plane's number, "lit already" (two surfaces at one depth must not both add their light),
// and the shadow mark.
constexpr unsigned kTagBits = 0x3f, kLitBit = 0x40, kMarkBit = 0x80;
static_assert(kNumbers == static_cast<int>(kTagBits));

/// The view and the shaders: while this key is the same, the set of hidden planes stays valid.
struct ViewCacheKey {
    std::uint64_t geometry = 0, transforms = 0, materials = 0; ///< revisions; no scene has these
    scene::Camera camera;
    ivec2 size{0}, corner{0}, regionSize{0};
    int shaderReloads = 0;
    friend bool operator==(const ViewCacheKey&, const ViewCacheKey&) = default;
};

/// What the lists and counts depend on besides the view.
struct PictureCacheKey {
    ViewCacheKey view;
    std::uint64_t lights = 0;
    PlanarParams params;
    friend bool operator==(const PictureCacheKey&, const PictureCacheKey&) = default;
};

class Planar final : public Technique {
public:
    params::ParamList params() override { return describe(params_); }
    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override;
    Progress render(Frame& frame) override;
    Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) override;
    std::vector<SceneShape> shapes(const scene::Snapshot& snapshot, const View& view, int light) override;
    bool samplesArea(const scene::Scene& scene, int light) const override { return isSampled(scene.light(light)); }
    std::string remark(const scene::MeshReport& report, const scene::Mesh& mesh) const override;

private:
    /// Which part of the casters is drawn, by where it is; `wherever`: all of it, clipped by nothing. Points beyond the
    /// light have a negative weight: GL draws them only with all signs inverted.
    enum class Part { between, beyondLight, behindPlane, wherever, whereverTurnedOver };

    /// Of one light with an area: how many of its points do not see a pixel.
    struct CountedPoints {
        PictureCacheKey key;
        std::vector<dvec3> pointsWorld; ///< in the order they are drawn
        std::size_t drawn = 0;
        gl::Texture2D counts;
    };

    [[nodiscard]] bool isSampled(const scene::Light& light) const;
    void chooseFor(const Frame& frame);
    void listFor(const Frame& frame);
    void countLists(Frame& frame) const;
    [[nodiscard]] bool showsTags(const Frame& frame) const;

    // drawing.cpp
    void findHidden(const Frame& frame);
    void tagReceivers(const Frame& frame, bool everywhere) const;
    static void drawReceiver(const Frame& frame, const gl::Program& program, const ChosenReceiver& one);
    void markShadows(const Frame& frame, const std::vector<LitPlane>& planes) const;
    void drawAsAsked(const Frame& frame, const gl::Program& program, const LitPlane& plane) const;
    void drawFlattened(const Frame& frame, const gl::Program& program, const LitPlane& plane, Part part) const;
    void drawSingle(const Frame& frame, const gl::Program& program, const SingleCaster& single) const;
    void hideBehind(const Frame& frame, const LitPlane& plane) const;
    void setPlaneState(const Frame& frame, const LitPlane& plane) const;
    static void setColor(const gl::Program& program, const LitPlane& plane, const vec4& color);
    static void clearBits(unsigned bits);
    void drawLit(const Frame& frame, const gl::Program& program, int light) const;
    void darken(const Frame& frame, int light) const;

    // counted_points.cpp
    bool countPoints(const Frame& frame, int light);
    void countOnePoint(const Frame& frame, int light, const dvec3& pointWorld, const gl::Framebuffer& counting) const;

    // stages.cpp
    void publishVisibility(Frame& frame, int light) const;
    void publishPlanes(Frame& frame) const;
    void publishTags(Frame& frame) const;
    void publishMarks(Frame& frame, int light) const;
    void publishPoints(Frame& frame, int light) const;
    [[nodiscard]] static int mostMarkedTag(const Frame& frame);
    void publishFlattened(Frame& frame, int light, int tag) const;
    [[nodiscard]] std::vector<KeyEntry> keyOf(const std::function<std::string(const ChosenReceiver&)>& named,
                                              const std::function<vec3(const ChosenReceiver&)>& colored) const;
    [[nodiscard]] static vec3 colorOf(const ChosenReceiver& receiver);
    void countServed(Frame& frame) const;

    PlanarParams params_;
    Receivers receivers_;
    Casters casters_;
    CasterBuffers buffers_;
    PictureCacheKey key_;                           ///< of what follows
    std::vector<ChosenReceiver> inView_, chosen_;   ///< all; lit ones first, then by their size in the picture
    bool leftOut_ = false;                          ///< there were more to choose from
    std::vector<std::vector<LitPlane>> lit_;        ///< per light: by its centre
    std::vector<scene::PicturePart> shadowedParts_; ///< per chosen receiver: where shadows can fall on it
    std::map<int, CountedPoints> counted_;          ///< of lights that are sampled
    ViewCacheKey hiddenIn_;                         ///< the view that hidden_ is of
    HiddenFaces hidden_;                            ///< of all in view, those that no pixel shows
    StencilledPasses passes_;
    gl::Program visibility_{"surface.vert", "shade_light.frag", {"VISIBILITY_ONLY"}};
    gl::Program shadeCounted_{
        "surface.vert", "shade_light.frag", {}, {{"shadow_visibility.glsl", "planar/counted_points.glsl"}}};
    gl::Program visibilityCounted_{"surface.vert",
                                   "shade_light.frag",
                                   {"VISIBILITY_ONLY"},
                                   {{"shadow_visibility.glsl", "planar/counted_points.glsl"}}};
    gl::Program tag_{"position.vert", "nothing.frag"};
    gl::Program paintPlane_{"position.vert", "constant.frag"};
    gl::Program flatten_{"planar/flatten.vert", "nothing.frag"};
    gl::Program flattenDivided_{"planar/flatten.vert", "nothing.frag", {"DIVIDE"}};
    gl::Program paintFlattened_{"planar/flatten.vert", "constant.frag"};
    gl::Program paintDivided_{"planar/flatten.vert", "constant.frag", {"DIVIDE"}};
    gl::Program behind_{"planar/behind.vert", "nothing.frag"};
    gl::Program addPoint_{"fullscreen.vert", "constant.frag"};
};

/// "(0, 1, 0)·P - 0.45 = 0"
std::string equation(const dvec4& plane);

} // namespace shadowlab::planar
