// The shadow volumes as shapes in the scene, for the camera outside, and as data of a probe.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <span>
#include <string>

#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/count/face_counter.h"
#include "techniques/technique.h"

namespace shadowlab::shadow_volume {

/// How volumes are drawn in pictures: as they are counted, or cut short where they end too far away to be seen.
struct ShownVolume {
    Construction construction = Construction::general;
    std::optional<double> distance; ///< how far vertices are pushed, metres; none: the picture chooses
};

/// The volume to be shown: of closed meshes only the lit half, as the lecture draws it; the other would double every face.
Volume buildShown(const scene::Object& object, const scene::Light& light, const CasterVolume& caster,
                  const ShownVolume& shown, std::vector<SilhouetteEdge>& silhouette);

/// Sides and, `withCaps`, the caps of the volumes of these casters, at the distance where they end or else cut off a little
/// beyond the scene, and the silhouettes: of each caster shapes of its own; where the view has a picked pixel, lines in place of the
/// faces. And the near-clip pyramid, on request.
std::vector<SceneShape> volumeShapes(const scene::Scene& scene, const View& view, int light,
                                     std::span<const CasterVolume* const> casters, bool withCaps,
                                     const ShownVolume& shown);

/// The faces that a picked pixel's line crosses, those that it enters and those that it leaves a volume by. What reaches infinity
/// is cut off a little beyond the scene.
std::vector<SceneShape> crossedShapes(const scene::Scene& scene, const VolumeProbe& probe);

/// Boxes around the casters, coloured by the method that counts their volumes.
void addCountMethods(std::vector<SceneShape>& shapes, std::span<const CasterVolume* const> casters,
                     const std::function<CountMethod(const CasterVolume&)>& countMethodOf);

/// The near rectangle of the view joined to the light, as lines: what stands in it casts its shadow on the near plane, and
/// there depth pass starts counting from a wrong number. Everitt and Kilgard 2002; Hornus, Hoberock, Lefebvre and Hart,
/// "ZP+: Correct Z-pass Stencil Shadows", 2005.
SceneShape nearClipPyramid(const scene::Scene& scene, const View& view, int light);

/// The volume as the stages show it (of a closed mesh only the lit half), with the end that is drawn. The caller sets
/// isPicked and holdsThePoint.
VolumeProbe::Caster describedCaster(const scene::Scene& scene, const scene::Light& light, const CasterVolume& caster,
                                    const ShownVolume& shown, const VolumeEnd& end);

/// "ball: 112 of 224 triangles face the light, 32 outline edges, extruded by 2 m"
std::string casterText(const scene::Scene& scene, const VolumeProbe::Caster& caster);

} // namespace shadowlab::shadow_volume
