// The receiver planes of a scene, and those of them that a picture needs.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <set>
#include <span>

#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/foundation/scene/query/view/picture_part.h"
#include "techniques/planar/projection.h"

namespace shadowlab::planar {

/// One flat face of one object that receives shadows.
struct Receiver {
    std::size_t object = 0;
    const FlatFace* face = nullptr;
    std::size_t rank = 0; ///< by size in the world, the largest first; it determines the colour
};

/// Object and face of receivers that no pixel shows.
using HiddenFaces = std::set<std::pair<std::size_t, const FlatFace*>>;

/// A receiver in a picture.
struct ChosenReceiver {
    Receiver receiver;
    int tag = 0; ///< its stencil value; of two that may overlap in the picture the one drawn first has the larger
    double pictureArea = 0;  ///< of the rectangle around it, as a share of the picture: at most 1
    scene::PicturePart part; ///< that holds the rectangle
    bool lit = false;        ///< the centre of a light shines on the side that the eye sees
    dvec4 planeView{0.0};    ///< (N, D)
    double unevenness = 0;   ///< of the face, in metres
    std::array<dvec3, 4> frameWorld{}, frameView{};
};

/// Eight pixels: parts of a picture are drawn with one pixel more on each side, and rounded besides.
inline dvec2 apartInPicture(ivec2 size) { return 16.0 / dvec2(size); }

/// All receivers, found again when the geometry changes.
class Receivers {
public:
    /// Looks at one more mesh; true when all are done.
    bool findNext(const scene::Snapshot& snapshot);
    [[nodiscard]] const std::vector<Receiver>& all() const { return all_; }

    /// Those in view, hidden by others or not, without tags. `bounds` are the scene's objectBounds.
    [[nodiscard]] std::vector<ChosenReceiver> inView(const scene::Scene& scene, const gl::EyeMatrices& eye,
                                                     std::span<const scene::Bounds> bounds) const;

private:
    void list(const scene::Scene& scene);

    struct Found {
        std::shared_ptr<const scene::Mesh> mesh; ///< kept alive, so that no other mesh gets its address
        std::vector<FlatFace> faces;
    };
    std::map<const scene::Mesh*, Found> meshes_;
    std::uint64_t findingGeometry_ = 0, listedGeometry_ = 0; ///< revisions: looked at now, and that all_ was made for
    std::size_t next_ = 0;                                   ///< object to be looked at
    std::vector<Receiver> all_;
};

struct Choice {
    std::vector<ChosenReceiver> receivers;
    bool leftOut = false; ///< true if there were more
};

/// Chooses at most `limit` receivers, and no more than there are tags for: first those whose visible side is lit, and of
/// these the largest in the picture. Two planes share a tag only if they are more than `apart` from each other in
/// normalised device coordinates, so that a pass restricted to the part of one cannot touch the other.
Choice choose(const std::vector<ChosenReceiver>& inView, int limit, const dvec2& apart, const HiddenFaces& hidden = {});

} // namespace shadowlab::planar
