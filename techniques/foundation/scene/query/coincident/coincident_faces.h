// Faces that coincide: two triangles in one plane that share more than an edge. A decal in the floor's plane, a lamp let into a
// ceiling, a house whose modeller wrote every face twice, once for each side.
//
// Two surfaces at one place would be seen in patches, as rounding has it. The rule for an eye, the same for rays, for the exact truth
// and for the rasteriser (seen_sides.h):
//     1. An emitter that shines toward the eye is seen, the surface of a light before other emitters. An emitter that is dark toward
//        the eye gives way.
//     2. Of others the one that faces the eye is seen: whose front, the side that sees the corners counter-clockwise, is toward it.
//     3. Of two alike the later one is seen: the later object of the scene, in one mesh the later face of the file.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// A side of a triangle among those that coincide: the greatest is seen.
struct SideRank {
    int rank = 0;            ///< rules 1 and 2
    std::uint32_t place = 0; ///< rule 3
    auto operator<=>(const SideRank&) const = default;
};

class CoincidentFaces {
public:
    CoincidentFaces() = default;
    /// Finds them. `before`: those of an earlier state of the scene; what is as it was then is not looked for again.
    explicit CoincidentFaces(const Scene& scene, const CoincidentFaces* before = nullptr);
    /// Those of the scene, shared by all who ask for them, from any thread.
    static std::shared_ptr<const CoincidentFaces> of(const Scene& scene);

    /// Two triangles that coincide, counted through all objects.
    struct Pair {
        std::uint32_t triangle, other;
        bool faceAlike; ///< both fronts are on one side of their plane
        double gap;     ///< metres by which rounding of float has moved their planes apart: they cross anywhere; 0: it has not
        auto operator<=>(const Pair&) const = default;
    };

    [[nodiscard]] bool isEmpty() const { return pairs_.empty(); }
    /// Each pair in both orders, sorted.
    [[nodiscard]] std::span<const Pair> pairs() const { return pairs_; }
    /// Those of one triangle.
    [[nodiscard]] std::span<const Pair> of(std::uint32_t triangle) const;
    [[nodiscard]] bool touches(std::uint32_t triangle) const { return flagsOf(triangle) != 0; }
    [[nodiscard]] bool areTogether(std::uint32_t triangle, std::uint32_t other) const;
    /// Has it a partner from which it differs by rounding of float, so that a ray from the one may meet the other?
    [[nodiscard]] bool isUneven(std::uint32_t triangle) const { return (flagsOf(triangle) & uneven) != 0; }
    [[nodiscard]] bool anyUneven() const { return anyUneven_; }

    /// Most contacts are those of closed bodies that stand on something, and an eye outside of a body never sees its inner sides. So
    /// this asks, of a side of a triangle: may an eye see another triangle in its place? From within a body it may see any.
    /// `isFront`: counter-clockwise as the triangle lies in the world, other than everywhere else here: asked for each pixel.
    [[nodiscard]] bool mayShowAnother(std::uint32_t triangle, bool isFront, bool eyeIsWithin) const {
        const std::uint8_t flags = flagsOf(triangle);
        return eyeIsWithin ? flags != 0 : (flags & (isFront ? front : back)) != 0;
    }
    /// Does any side, for an eye outside of all bodies?
    [[nodiscard]] bool mayAnyShowAnother() const { return anyShown_; }
    /// Is the place within the box of a closed body that has contacts?
    [[nodiscard]] bool isWithinBody(const dvec3& positionWorld) const;
    /// Within an object: does the triangle belong to the outer of two closed skins at one place (outward_shells.h)?
    [[nodiscard]] bool isInOuterSkin(const Object& object, std::uint32_t triangle) const {
        const std::vector<bool>& outer = withinMeshes_.at(object.mesh)->inOuterSkin;
        return !outer.empty() && outer[triangle];
    }
    /// Is that side of the triangle the inner one of a closed body?
    [[nodiscard]] static bool isInner(const Scene& scene, const Object& object, bool isFront);

    /// A triangle that coincides with another one.
    struct Triangle {
        std::uint32_t number;            ///< through all objects
        std::uint32_t object, inObject;  ///< which object's, and its number there
        std::uint32_t place;             ///< rule 3
        int rankOfFront, rankOfBack;     ///< rules 1 and 2
    };
    /// All of them, by number.
    [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
    /// One of them.
    [[nodiscard]] const Triangle& triangle(std::uint32_t number) const;
    /// `isFront`: its counter-clockwise side, as the mesh has it.
    [[nodiscard]] SideRank rank(std::uint32_t number, bool isFront) const {
        const Triangle& one = triangle(number);
        return {isFront ? one.rankOfFront : one.rankOfBack, one.place};
    }

private:
    enum Flag : std::uint8_t { together = 1, front = 2, back = 4, uneven = 8 }; ///< front and back as they lie in the world
    [[nodiscard]] std::uint8_t flagsOf(std::uint32_t triangle) const { return flags_.empty() ? 0 : flags_[triangle]; }

    void findWithinMeshes(const Scene& scene, const CoincidentFaces* before);
    void findBetweenObjects(const Scene& scene, const CoincidentFaces* before);
    void numberPairs(const Scene& scene);
    void listTriangles(const Scene& scene, std::span<const std::uint32_t> firstOfObject);
    void flagTriangles(const Scene& scene);

    /// Triangles within their objects.
    struct Found {
        std::uint32_t triangle, other;
        bool faceAlike;
        double gap;
    };
    using Founds = std::shared_ptr<const std::vector<Found>>;
    struct WithinMesh {
        std::vector<Found> found;
        std::vector<bool> inOuterSkin; ///< of each triangle; empty: no skin lies at the place of another
    };
    struct Standing { ///< an object, as far as its contacts depend on it
        std::shared_ptr<const Mesh> mesh;
        dmat4 worldFromObject;
        bool operator==(const Standing&) const = default;
    };
    struct BetweenObjects {
        Standing first, second;
        Founds found;
    };
    std::map<std::shared_ptr<const Mesh>, std::shared_ptr<const WithinMesh>> withinMeshes_;
    std::map<std::pair<std::size_t, std::size_t>, BetweenObjects> betweenObjects_; ///< by the numbers of the objects

    std::vector<Pair> pairs_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint8_t> flags_; ///< per triangle of the scene; empty: none
    std::vector<Bounds> bodies_;      ///< closed ones with contacts
    bool anyUneven_ = false, anyShown_ = false;
    Revisions revisions_;
};

} // namespace shadowlab::scene
