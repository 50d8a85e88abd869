// A scene prepared for radiosity: its sides cut into patches, and the share of the surroundings that each of them sees. None of
// it depends on brightness, so all of it is kept while only lights change.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <map>
#include <optional>
#include <span>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/radiosity/form_factors/occlusion.h"
#include "techniques/radiosity/patches/patches.h"
#include "techniques/radiosity/patches/winding_number.h"
#include "techniques/radiosity/room/importance.h"
#include "techniques/radiosity/room/patch_colors.h"
#include "techniques/radiosity/room/refinement.h"
#include "techniques/radiosity/room/sides.h"
#include "techniques/radiosity/simplify/simplified_scene.h"

namespace shadowlab::radiosity {

struct RoomSettings {
    std::size_t patches = 0;       ///< the budget; a scene with more faces that cannot be simplified has more patches
    bool cutsAtContacts = true;    ///< false: light leaks under what stands on a patch (teaching)
    std::vector<bool> lightWithin; ///< for each object: is there a light within its bounding box?
    bool coarsensGround = true;    ///< false: a wide ground is cut as fine as all else (tests)
    bool dividesNearEmitters = true; ///< false: what lies close to emitters is cut as large as all else (tests)
    bool leavesOutFolds = true;    ///< false: patches in folds of simplified meshes stay, and stay dark (tests)
    friend bool operator==(const RoomSettings&, const RoomSettings&) = default;
};

class Room {
public:
    /// `scene` must live until advance() has returned true. `eye`: what matters to its picture is cut more finely; nothing: all alike.
    Room(const scene::Scene& scene, RoomSettings settings, std::optional<Eye> eye = {});
    Room(const Room&) = delete; // its members refer to each other
    Room& operator=(const Room&) = delete;

    /// Continues until all is done (true) or the deadline has passed, but always does some work.
    bool advance(std::chrono::steady_clock::time_point deadline);

    // The functions below may be called once advance() has returned true.

    [[nodiscard]] const SimplifiedScene& simple() const { return *simple_; }
    /// The triangles of the simplified scene; originWorld is the origin of centred space.
    [[nodiscard]] const trace::WorldTriangles& world() const { return world_; }
    /// Of the same.
    [[nodiscard]] const trace::SceneTracer& tracer() const { return tracer_; }
    [[nodiscard]] const Sides& sides() const { return sides_; }
    /// Only the sides that exchange light.
    [[nodiscard]] const Faces& exchangingFaces() const { return exchangingFaces_; }
    /// Their patches, in the order of their faces.
    [[nodiscard]] const std::vector<Patch>& patches() const { return patches_; }
    /// The same, followed by the patches of the loose sides, which exchange no light. Their face numbers are those in sides().
    [[nodiscard]] const std::vector<Patch>& allPatches() const { return allPatches_; }
    /// To the eye.
    [[nodiscard]] const Importance& importance() const { return importance_; }
    /// False: everything matters alike, or the budget is too small to divide faces by it.
    [[nodiscard]] bool usesImportance() const { return usesImportance_; }
    /// What would matter to another eye.
    [[nodiscard]] Importance importanceTo(const std::optional<Eye>& eye) const;
    /// The share of the view of each of patches() that is no surface: 0..1.
    [[nodiscard]] const std::vector<double>& surroundings() const { return surroundings_; }
    /// Of those of patches() with at most that share: the area-weighted mean of it, and their area, square metres.
    struct MeanView {
        double share = 0, area = 0;
    };
    [[nodiscard]] MeanView meanView(double most) const;
    /// How many patches were left out because they lie under or in a closed body.
    [[nodiscard]] std::size_t coveredPatches() const { return coveredPatches_; }
    /// How many were left out because they lie in a fold that simplification made.
    [[nodiscard]] std::size_t foldedPatches() const { return foldedPatches_; }
    /// For each of patches(), 1 if light of emitters is followed from there (near_emitters.h), else 0.
    [[nodiscard]] const std::vector<std::uint8_t>& followed() const { return followed_; }
    /// For each of patches(), how often refinement has cut it.
    [[nodiscard]] const std::vector<std::uint8_t>& levels() const { return levels_; }
    /// Cuts some of the patches; the others stay. Returns for each patch its number before, or Refined::kNew.
    std::vector<std::uint32_t> refine(std::span<const Refinement> refinements);

    [[nodiscard]] const Occlusion& occlusion() const { return *occlusion_; }

    [[nodiscard]] const Face& faceOf(const Patch& patch) const { return sides_.faces.all[patch.face]; }
    [[nodiscard]] const scene::Material& materialOf(const Patch& patch) const {
        return simple_->scene->materials[faceOf(patch).material];
    }
    /// Diffuse reflectance of each of allPatches(), the mean over the patch. Found when first asked for, and after refine().
    [[nodiscard]] const std::vector<dvec3>& reflectances() const;
    /// What the surface of the patch emits, W/m^2.
    [[nodiscard]] dvec3 emissionOf(const Patch& patch) const;
    /// The area for which the patch of a simplified body stands, seen from outside, over its own: with so much more emission the body sends as much light as the
    /// original, also where some of its patches were left out as they lie in its own folds. 1 for all others: what encloses a place brings as much light to it
    /// whatever its area is.
    [[nodiscard]] double areaFactor(const Patch& patch) const;
    [[nodiscard]] bool isSimplified(std::uint32_t object) const { return !simple_->cornersOfObject[object].empty(); }
    [[nodiscard]] const scene::Object& objectOf(const Patch& patch) const {
        return simple_->scene->objects[faceOf(patch).object];
    }

private:
    [[nodiscard]] dvec3 reflectanceOf(const Patch& patch) const;
    void sampleSurroundings(std::size_t patch);
    [[nodiscard]] bool seesLittleOfOutside() const;
    void sampleWindows(std::size_t patch);
    void findFollowed();
    enum class Phase { simplify, cut, sample, sampleWindows, done };
    void simplify();
    bool simplifiesFurther();
    void cut();
    double cutByWhatMatters();
    double cutWithinBudget(const FaceParts& parts);
    struct Cut {
        double size = 0; ///< of the longest edges, metres
        std::vector<Patch> patches;
        std::size_t covered = 0; ///< how many were left out
    };
    [[nodiscard]] Cut cutInto(std::size_t pieces, const FaceParts& parts) const;
    [[nodiscard]] bool isCovered(const Patch& patch) const;
    [[nodiscard]] bool isOutsideOfSimplified(const Patch& patch) const;
    [[nodiscard]] std::size_t partOf(const Patch& patch) const;
    void leaveOutCovered();

    const scene::Scene& scene_;
    RoomSettings settings_;
    std::optional<Eye> eye_;
    Phase phase_ = Phase::simplify;
    bool looksForWindows_ = false; ///< where no ray to the surroundings was found, more look for some
    std::size_t mostSides_ = 0; ///< that simplified meshes may have
    int simplifications_ = 0;
    std::optional<SimplifiedScene> simple_;
    std::optional<PatchColors> colors_;
    mutable std::vector<dvec3> reflectances_; ///< empty: not found yet
    trace::WorldTriangles world_;
    Faces plain_; ///< the faces that block light
    Sides sides_;
    Faces exchangingFaces_;
    Ground ground_;
    Importance importance_;
    bool usesImportance_ = false;
    std::vector<Patch> patches_, allPatches_;
    std::optional<trace::Bvh> bvh_;
    std::optional<Occlusion> occlusion_;
    std::optional<ClosedBodies> bodies_;
    trace::SceneTracer tracer_;
    std::size_t nextPatch_ = 0;
    std::vector<double> surroundings_, inBodies_, folded_; ///< of each patch, shares of what leaves it
    std::size_t coveredPatches_ = 0, foldedPatches_ = 0, loosePatches_ = 0;
    std::vector<std::uint8_t> levels_, followed_; ///< of each patch
    std::map<std::pair<std::uint32_t, std::size_t>, double> foldedAreas_; ///< of an object and its part: what was left out of its outside, m^2
};

} // namespace shadowlab::radiosity
