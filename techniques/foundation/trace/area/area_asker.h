// Answers for one point after the other what it sees of a light, among obstacles found for all of them together.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/area/light_piece.h"
#include "techniques/foundation/trace/area/obstacles.h"
#include "techniques/foundation/trace/area/uniform_pieces.h"

namespace shadowlab::trace {

class AreaVisibility::Asker {
public:
    explicit Asker(const AreaVisibility& owner) : owner_(owner), bvh_(owner.tracer_.bvh()) {}
    /// Those of the points that will ask next, and of where they move. They must live as long.
    void setObstacles(const Obstacles& obstacles) {
        obstacles_ = &obstacles;
        allFree_.reset();
    }
    AreaShare ask(const SurfacePoint& point, double move);
    AreaIrradiance askIrradiance(const SurfacePoint& point, const dvec3& normalWorld);

private:
    /// Shares, 0..1, of a piece of the light that are seen: of its area, and of its irradiance.
    struct Seen {
        double area = 0, irradiance = 0;
    };
    bool lookFrom(const SurfacePoint& point, double move);
    [[nodiscard]] bool isLeft(std::uint32_t primitive) const {
        return owner_.tracer_.isLeft(point_.primitive, primitive);
    }
    struct LightPlane;
    void addLines();
    /// `isContour()` is asked last: whether the line from one place to the other is one for this point.
    template <typename IsContour>
    bool comesBefore(const LightPlane& plane, const dvec3& firstCentred, const dvec3& secondCentred, const IsContour& isContour);
    void addContour(const dvec3& firstCentred, const dvec3& secondCentred);
    void mindCuts();
    void addCrossings();
    void mindWhatIsNear(const dvec3& up);
    [[nodiscard]] double farthestOnLight() const;
    [[nodiscard]] int turnAt(const SurfaceEdges::Edge& edge) const;
    [[nodiscard]] double heightOver(const Triangle& triangle) const;
    [[nodiscard]] double irradianceOf(const LightPiece& piece, const dvec3& normalWorld) const;
    Seen seenOf(const LightPiece& piece, std::span<const dvec2> polygon, const dvec3& normalWorld);
    [[nodiscard]] bool isFree(dvec2 place);
    [[nodiscard]] bool isFreeOf(bool perforated, dvec2 place);
    Seen sampledSeenOf(const LightPiece& piece, std::span<const dvec2> polygon, const dvec3& normalWorld);

    const AreaVisibility& owner_;
    const Bvh& bvh_;
    const Obstacles* obstacles_ = nullptr;
    /// Without obstacles: whether all of these points see all that is above their triangles, or nothing; none: not yet known.
    std::optional<bool> allFree_;
    UniformPieces pieces_;
    std::vector<Contour> contours_;
    std::vector<std::uint32_t> chords_; ///< of cuts that are seen before the light
    std::vector<dvec3> borders_;        ///< lines of chords that are no contours (UniformPieces::cut)
    // Of the point that asks.
    SurfacePoint point_;
    dvec3 positionCentred_{0.0};
    SeenLight seen_;
    std::vector<dvec2> outline_; ///< of what lies above the plane of its triangle
    double move_ = 0, change_ = 0;
    std::uint32_t lastBlocker_ = kNoPrimitive;
};

} // namespace shadowlab::trace
