// The receiver planes of a scene, and those of them that a picture needs.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>

#include "techniques/foundation/gl/surfaces.h"
#include "techniques/planar/projection.h"

namespace shadowlab::planar {

/// One flat face of one object that receives shadows.
struct Receiver {
    std::size_t object = 0;
    const FlatFace* face = nullptr;
};

/// A receiver in a picture.
struct ChosenReceiver {
    Receiver receiver;
    int tag = 0;            ///< its stencil value; of two the one drawn first has the larger
    double pictureArea = 0; ///< of the rectangle around it, as a share of the picture: at most 1
    int pixels = 0;         ///< that show it, once it has been drawn
    dmat4 viewFromMesh{1.0};
    dvec4 planeView{0.0};  ///< (N, D)
    double unevenness = 0; ///< of the face, in metres
    std::array<dvec3, 4> frameView{};
};

/// Six bits of the stencil; two are for other things (technique.cpp).
constexpr int kMostReceivers = 63;

/// All receivers, found again when the geometry changes.
class Receivers {
public:
    /// Looks at one more mesh; true when all are done.
    bool findNext(const scene::Snapshot& snapshot);
    [[nodiscard]] const std::vector<Receiver>& all() const { return all_; }

    /// Those in view, hidden or not, largest in the picture first, and no more than `limit` of them.
    [[nodiscard]] std::vector<ChosenReceiver> choose(const scene::Scene& scene, const gl::EyeMatrices& eye,
                                                     int limit) const;

private:
    struct Found {
        std::shared_ptr<const scene::Mesh> mesh; ///< kept, so that its address stays its own
        std::vector<FlatFace> faces;
    };
    std::map<const scene::Mesh*, Found> meshes_;
    std::uint64_t listedGeometry_ = 0; ///< revision that all_ was made for
    std::vector<Receiver> all_;
};

} // namespace shadowlab::planar
