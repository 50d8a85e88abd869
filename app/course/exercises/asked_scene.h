// The small scene behind an exercise, and what the program knows about it.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/probe.h"

namespace shadowlab::course {

/// From the text of a scene file, without files of its own.
scene::Snapshot sceneFromText(const std::string& text);

/// An object that casts, as a line of a scene file: a plate at a height, or a box.
std::string plateText(const std::string& name, dvec3 centreWorld, dvec2 sizeXz);
std::string boxText(const std::string& name, dvec3 lowerWorld, dvec3 upperWorld);

/// A scene file: a lamp, the eye and the place in the middle of its picture, and objects. The floor y = 0 casts no shadow: its volume, below
/// it, would be counted as well.
std::string sceneText(const std::string& light, dvec3 eyeWorld, dvec3 targetWorld, const std::string& objects);
std::string pointLightText(dvec3 positionWorld);

/// Rays through the scene.
trace::SceneTracer tracerOf(const scene::Snapshot& scene);
/// Where the ray from the eye through the middle of the picture ends.
trace::SurfacePoint middlePoint(const trace::SceneTracer& tracer);
/// What a technique knows of that point. `settings`: parameters and their values.
Probe middleProbe(const scene::Snapshot& scene, const std::string& technique,
                  const std::vector<std::pair<std::string, std::string>>& settings);

} // namespace shadowlab::course
