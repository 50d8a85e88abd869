// Cascades: several maps of one directional light, each for a slice of what the eye sees, so that near shadows get small
// texels and far ones large: about as many pixels of the screen for each.
//
// Engel, "Cascaded Shadow Maps", ShaderX5, 2006; Zhang, Sun, Xu and Lun, "Parallel-Split Shadow Maps for Large-Scale Virtual
// Environments", VRCIA 2006 (the splits); Valient, "Stable Rendering of Cascaded Shadow Maps", ShaderX6, 2008 (spheres,
// whole texels); Lauritzen, Salvi and Lefohn, "Sample Distribution Shadow Maps", I3D 2011 (bounds from the picture's
// depths).
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/shadow_map/fit/fit.h"

namespace shadowlab::shadow_map {

/// Where `count` slices of a range of distances end. mix 0: all equally deep; 1: each as many times deeper as the one
/// before, which keeps the size of a texel on screen the same if the light comes from above; between, the mean of both.
std::vector<double> splitDistances(double nearest, double farthest, int count, double mix);

/// A ball around the slice of the eye's view between two distances, in the eye's view space: its middle on the axis at
/// (0, 0, -distance). It depends on the angle of view alone, not on where the eye is or looks.
struct SliceBall {
    double distance, radius;
};
SliceBall ballAround(const FitEye& eye, double nearest, double farthest);

/// The part of the light's view that each cascade's map holds. Sets where cascades end and fade in `maps`, whose origin is
/// known. `region` is what casters and receivers share.
std::vector<Box> cascadeParts(const FitRequest& request, const Box& region, const dmat4& lightViewFromLightRelative,
                              LightMaps& maps);

} // namespace shadowlab::shadow_map
