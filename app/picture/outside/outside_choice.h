// Which of a technique's shapes the picture from outside shows: those of one caster, or of all.
//
// The volumes of a whole scene hide one another and the scene itself; one of them alone can be followed from the silhouette to
// the bottom cap. What all objects share, such as the view of a shadow map, is always shown.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/technique.h"

namespace shadowlab::picture {

/// What somebody asks of the picture from outside.
struct OutsideChoice {
    bool allVolumes = false;           ///< of all casters, not of one
    std::optional<std::size_t> caster; ///< whose volume, as an index of an object; none, or no caster: the program chooses
    bool nearClipPyramid = false;
    friend bool operator==(const OutsideChoice&, const OutsideChoice&) = default;
};

/// `volumes` as it is asked for in words: "all", or the name of an object of the scene. Throws Error (usage), beginning with
/// `asked`: what the words stand in.
OutsideChoice outsideChoiceOf(const std::string& volumes, bool nearClipPyramid, const scene::Scene& scene,
                              const std::string& asked);
/// Those words; empty: the program chooses.
std::string volumesText(const OutsideChoice& choice, const scene::Scene& scene);

/// Is there a shape of that object?
bool hasShapesOf(const std::vector<SceneShape>& shapes, std::size_t object);

/// The object in whose volume the probed point is, of a technique that has volumes; of several the first.
std::optional<std::size_t> casterAbove(const Probe& probe);

/// The object whose shadow takes most of the eye's picture, of those that have shapes, found by rays through a few hundred of
/// its pixels; of none is a shadow seen: the first that has shapes. None has shapes: nothing.
std::optional<std::size_t> mostSeenCaster(const trace::SceneTracer& tracer, const View& eye, int light,
                                          const std::vector<SceneShape>& shapes);

/// The shapes that are shown: without those of other objects than `caster`, and without those on request that nobody asked for.
/// Shapes that follow one another and are of one kind and label become one.
std::vector<SceneShape> chosenShapes(const std::vector<SceneShape>& shapes, const OutsideChoice& choice,
                                     std::optional<std::size_t> caster);

} // namespace shadowlab::picture
