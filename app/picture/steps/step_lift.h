// Steps before a light is on leave a picture that holds ambient light and emission alone, nearly black. In step mode it is shown
// brighter, and by how much is said.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/technique.h"
#include "techniques/foundation/gl/texture.h"

namespace shadowlab::picture {

/// How many times brighter the picture after a step is shown: the largest power of two by which a white surface in the scene's
/// ambient light is no brighter than white. 1: as it is, for a step after which some light is on, or where there is nothing to be
/// lifted. `radiance`: the target after the step, of which `region` is drawn. It depends on the scene alone, so that two techniques
/// beside each other are lifted alike. Needs a current GL context.
int stepLift(const gl::Texture2D& radiance, const Region& region, const scene::Scene& scene);

/// "shown 8 times brighter"; empty where it is shown as it is.
std::string liftNote(int lift);

} // namespace shadowlab::picture
