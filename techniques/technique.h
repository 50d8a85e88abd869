// The contract every technique meets, and the words it is described with.
//
// A technique turns a scene and a camera into a picture with shadows. It draws in *passes* (what the lecture's numbered
// steps are) and publishes *stages* (the intermediate pictures worth a slide). It never sees a window, a widget, a file
// or the command line. A technique is a folder under techniques/ with a technique.cpp that defines
//
//     namespace shadowlab::<folder> { std::span<const TechniqueInfo> techniques(); }
//
// and, if it has shaders, a folder of the same name under shaders/. Nothing else is edited to add one.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/params/param.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/probe.h"
#include "techniques/scene_shape.h"

namespace shadowlab {

class Frame;

constexpr int kNoLight = -1;

/// Lines of a text, counted from 1, the last one included; {0, 0}: none.
struct LineRange {
    int first = 0, last = 0;
};

/// A name that stands in formulas, pseudocode or source, and the fact of a probe that is its value at a picked pixel.
struct NamedValue {
    std::string_view name, fact;
};

/// One step of an algorithm, in the words a teacher would use. `perLight`: it is done once for each light.
struct PassInfo {
    std::string_view id, title, why, glState;
    bool perLight = false;
    /// The stage that shows what the pass wrote, where that is not the picture (but a stencil, a map, answers of rays).
    std::string_view shownBy = {};
    /// The lines of TechniqueInfo::pseudocode that this step carries out.
    LineRange pseudocodeLines = {};
    /// What it computes, as it would stand on a blackboard, in lines; empty: nothing that needs one.
    std::string_view formula = {};
    /// Where it is in the source: names of anchors (techniques/source_text.h), with blanks between, the most telling first.
    std::string_view anchors = {};
    /// Names whose value right after this step is another fact than TechniqueInfo::values has for them.
    std::span<const NamedValue> values = {};
};

/// What a stage's texture holds, and so how it is shown.
enum class StageKind {
    radiance,   ///< linear RGB, shown with the scene's exposure
    scalar,     ///< red: a value mapped through a palette between minimum and maximum; green: 1 where there is one
    count,      ///< red: a signed count mapped through a diverging palette; green: 1 where there is one
    swatches,   ///< linear display colours (no exposure), explained by a key
    visibility, ///< red: visible fraction of the light; green: 1 where a surface covers the pixel centre
};

struct StageInfo {
    std::string_view id, caption;
    StageKind kind = StageKind::radiance;
    bool perLight = false;
    bool followsPicked = false; ///< it is about View::picked, where there is one
    bool isElsewhere = false;   ///< seen from the light, or a chart: what the eye sees has no place in it, whatever its size
};

/// One colour and what it stands for.
struct KeyEntry {
    vec3 colorLinear;
    std::string label;
};

/// How to show a published texture. Only the members its StageKind speaks of matter.
struct Display {
    double minimum = 0, maximum = 1;
    std::string unit;          ///< of the values between minimum and maximum
    std::vector<KeyEntry> key; ///< swatches
};

/// A rectangle of a picture, in pixels from its upper left corner.
struct Region {
    ivec2 corner{0}, size{0};
    friend bool operator==(const Region&, const Region&) = default;
};

/// One question to a technique: this eye, this many pixels, this sample of a progressive sequence.
struct View {
    scene::Camera camera;
    ivec2 size{1280, 720};
    Region region; ///< the part that is wanted; empty: all of it. What lies outside need not be drawn.
    std::uint32_t sample = 0;
    std::uint32_t seed = 0;
    /// Somebody wants to know about this one: shapes() leaves out what stands for all pixels where probe() tells of one.
    std::optional<ivec2> picked{};
    /// A second one, for techniques in which two places have to do with one another; all others take no notice.
    std::optional<ivec2> partner{};
};

/// The part of the picture that is drawn: the view's region, or all of it where it has none.
inline Region drawnRegion(const View& view) {
    const bool all = view.region.size.x <= 0 || view.region.size.y <= 0;
    return all ? Region{ivec2(0), view.size} : view.region;
}

/// A parameter of a technique that trades speed for error: `report` draws with each of its values.
struct Sweep {
    std::string_view title;         ///< "Hard map"
    std::string_view settings = {}; ///< that all its points have, "param=value" with blanks between
    std::string_view varies = {};   ///< the parameter that changes; empty: the settings alone are one point
    std::string_view values = {};   ///< of it, with blanks between, the cheapest first
    std::string_view quick = {};    ///< those that a quick report is content with; empty: all
    bool onlyFull = false;          ///< left out of quick reports
    enum class Lights { any, withArea, directional } lights = Lights::any; ///< those that it makes sense for
};

using Deadline = std::chrono::steady_clock::time_point;

struct Progress {
    double done = 1.0; ///< 0..1
    bool converged = true;
};

class Technique {
public:
    virtual ~Technique() = default;
    Technique() = default;
    Technique(const Technique&) = delete; // parameter lists point into the object
    Technique& operator=(const Technique&) = delete;

    /// The knobs, described once; they refer to fields of this object.
    virtual params::ParamList params() { return {}; }
    /// Slow work that needs no GL: silhouettes, trees, form factors. Called before every render; does only what changed
    /// revisions and parameters demand, and returns early, unconverged, when the deadline passes.
    virtual Progress prepare(const scene::Snapshot&, Deadline) { return {}; }
    /// Draws into frame.target(), pass by pass. GL thread, baseline state set, prepare() has converged.
    virtual Progress render(Frame& frame) = 0;
    /// With its settings, does it find out how much of a light's area a point sees, by samples of it or in another way? It is
    /// then judged by that share, else by whether the light's centre is seen. For lights without an area: never.
    [[nodiscard]] virtual bool samplesArea(const scene::Scene&, int /*light*/) const { return false; }
    /// What there is to say about one pixel for one light.
    virtual Probe probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light);
    /// What there is of the technique in the scene for one light, seen from outside. What has no end in truth ends where
    /// the scene does, a little beyond its bounds. GL thread not needed; prepare() has converged for this snapshot.
    virtual std::vector<SceneShape> shapes(const scene::Snapshot&, const View&, int /*light*/) { return {}; }
    /// What `inspect` says about a mesh for this technique; empty when there is nothing to say.
    virtual std::string remark(const scene::MeshReport&, const scene::Mesh&) const { return {}; }
};

/// The lecture's own algorithms (techniques/lecture) are short and get wrong what the lecture says they get wrong; a
/// production technique refines one of them.
enum class TechniqueGroup { production, lecture };
std::string_view toText(TechniqueGroup group);

/// What is known about a technique without making one, and without a GL context.
struct TechniqueInfo {
    std::string_view id, title;
    std::string_view paper;                   ///< author, year, title
    std::string_view getsWrong;               ///< one line for the README table
    int order = 0;                            ///< didactic order of lists
    TechniqueGroup group = TechniqueGroup::production;
    std::string_view sister = {};             ///< of the lecture's: the id of the production technique that refines it
    std::vector<scene::LightType> lightTypes; ///< served (area lights may be served as points)
    std::vector<PassInfo> passes;
    std::vector<StageInfo> stages;
    std::string_view pseudocode = {}; ///< the whole algorithm as a lecture writes it, in lines; empty: it has none
    std::vector<NamedValue> values{}; ///< of what its steps' formulas and source lines are about
    std::vector<Sweep> sweeps{};      ///< what `report` tries; empty: its defaults
    std::unique_ptr<Technique> (*make)() = nullptr;
};

/// Stages that the program asks every technique for: what it says of one light, and how many pixels a texel of its shadow map
/// covers.
inline constexpr std::string_view kVisibilityStage = "visibility", kTexelSizeStage = "texel-size";

/// Does the technique draw that stage itself?
bool publishes(const TechniqueInfo& info, std::string_view stage);

/// The lines of the technique's pseudocode that a step carries out; empty: there are none.
std::string pseudocodeOf(const TechniqueInfo& info, const PassInfo& pass);

} // namespace shadowlab
