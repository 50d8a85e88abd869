// Answers for one point after the other what it sees of a light, among candidate triangles found for all of them together.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/area/light_piece.h"
#include "techniques/foundation/trace/area/uniform_pieces.h"

namespace shadowlab::trace {

class AreaVisibility::Asker {
public:
    /// `box`: of the points that will ask, and of where they move.
    Asker(const AreaVisibility& owner, const CentredBox& box, double largestMove,
          const std::vector<std::uint32_t>& candidates);
    AreaShare ask(const SurfacePoint& point, double move);
    AreaIrradiance askIrradiance(const SurfacePoint& point, const dvec3& normalWorld);

private:
    /// Shares, 0..1, of a piece of the light that are seen: of its area, and of its irradiance.
    struct Seen {
        double area = 0, irradiance = 0;
    };
    bool lookFrom(const SurfacePoint& point, double move);
    [[nodiscard]] bool isLeft(std::uint32_t primitive) const { return owner_.tracer_.isLeft(point_.primitive, primitive); }
    void findEdges(const CentredBox& box, const std::vector<std::uint32_t>& candidates);
    void addEdges();
    void addCrossings();
    void mindWhatIsNear(const dvec3& up);
    [[nodiscard]] double farthestOnLight() const;
    [[nodiscard]] double nearness(double move, double farthest) const;
    [[nodiscard]] int turnAt(const SurfaceEdges::Edge& edge) const;
    [[nodiscard]] double heightOver(const Triangle& triangle) const;
    Seen seenOf(const LightPiece& piece, std::span<const dvec2> polygon, const dvec3& normalWorld);
    [[nodiscard]] bool isFree(dvec2 place, bool perforated);
    Seen sampledSeenOf(const LightPiece& piece, std::span<const dvec2> polygon, const dvec3& normalWorld);

    const AreaVisibility& owner_;
    const Bvh& bvh_;
    std::vector<std::uint32_t> edgeNumbers_; ///< that may be contours for one of the points
    std::vector<std::uint32_t> near_;        ///< triangles that may touch the light, or a point
    bool perforated_ = false;                ///< true if any triangle has holes
    UniformPieces pieces_;
    std::vector<Contour> contours_;
    // Of the point that asks.
    SurfacePoint point_;
    dvec3 positionCentred_{0.0};
    SeenLight seen_;
    std::vector<dvec2> outline_; ///< of what lies above the plane of its triangle
    double move_ = 0, change_ = 0;
    std::uint32_t lastBlocker_ = kNoPrimitive;
};

} // namespace shadowlab::trace
