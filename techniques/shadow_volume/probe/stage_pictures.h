// The stages of shadow volumes: facing signs, silhouettes, the volumes themselves, the counts.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/probed/volume_probe.h"
#include "techniques/shadow_volume/count/face_counter.h"
#include "techniques/shadow_volume/probe/shapes.h"

namespace shadowlab::shadow_volume {

class StagePictures {
public:
    /// Every triangle in the colour of its sign of N.L.
    void publishFacing(Frame& frame, int light) const;
    /// Casters in the colour of the method that counts their volumes.
    void publishCountMethods(Frame& frame, int light, std::span<const CasterVolume* const> casters,
                             const std::function<CountMethod(const CasterVolume&)>& countMethodOf) const;
    /// Silhouette, boundary and non-manifold edges over the picture.
    void publishSilhouettes(Frame& frame, int light, std::span<const CasterVolume* const> casters) const;
    /// The faces, translucent, over the picture: by the side they turn to the viewer, or by the part they belong to.
    void publishFaces(Frame& frame, int light, std::span<const CasterVolume* const> casters, bool byPart,
                      const ShownVolume& shown) const;
    /// The stencil's counts where there is a surface; `bothSigns` reads 128 to 255 as -128 to -1.
    void publishCount(Frame& frame, std::string_view stage, int light, bool bothSigns) const;
    /// The same for given counts, one per pixel, rows from below.
    void publishCount(Frame& frame, std::string_view stage, int light, const std::vector<float>& counts) const;

private:
    gl::Program facing_{"surface.vert", "shadow_volume/facing_sign.frag"};
    gl::Program tint_{"surface.vert", "constant.frag"};
    gl::Program edges_{"shadow_volume/edge.vert", "constant.frag"};
    gl::Program faces_{"shadow_volume/extrude.vert", "shadow_volume/faces.frag"};
};

} // namespace shadowlab::shadow_volume
