// The shadow volume of one caster in perspective: the caster, its outline, what is extruded of it, and what it meets.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/figures/volume/caster_solid.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

class VolumeSketch {
public:
    /// `hasEnds`: there is room for the ends of the volume, also where they lie beyond what it meets.
    VolumeSketch(const FigureSource& source, const CasterSolid& solid, const drawing::Box& area, bool hasEnds = false);

    /// The objects on which the shadow falls, with what of the volume lies beyond them, and the shadow.
    void drawReceivers(drawing::Drawing& drawing) const;
    /// The volume around its caster. `paleness` 0..1 of the caster; `opacity` of a side where it is not hidden.
    void drawVolume(drawing::Drawing& drawing, drawing::Labels& labels, double paleness, double opacity) const;
    /// The light source, and its rays past the borders of the caster.
    void drawLight(drawing::Drawing& drawing, drawing::Labels& labels, bool withRays) const;
    /// What the parts are called.
    void nameParts(drawing::Drawing& drawing, drawing::Labels& labels) const;

    [[nodiscard]] const SpaceView& view() const { return *view_; }
    /// P' of a vertex as it is drawn: cut off where the volume goes on for long.
    [[nodiscard]] dvec3 drawnEnd(std::uint32_t vertex) const;
    /// Where the way of a vertex first meets another object; else P'.
    [[nodiscard]] dvec3 firstMet(std::uint32_t vertex) const;
    [[nodiscard]] bool isCutOff() const { return isCutOff_; }
    [[nodiscard]] dvec3 drawnLight() const { return lightWorld_; }
    [[nodiscard]] bool lightIsNear() const { return lightIsNear_; }
    /// Where the volume meets other objects: two points for each piece.
    [[nodiscard]] const std::vector<dvec3>& curveWorld() const { return curveWorld_; }
    /// Of which that is the surface.
    [[nodiscard]] const std::string& receiver() const { return receiver_; }

private:
    struct Hit {
        dvec3 placeWorld{0.0};
        double distance = 0; ///< metres from where the ray begins
        std::size_t object = 0;
        dvec4 planeWorld{0.0}; ///< of the triangle
    };
    /// A piece of an extruded outline edge.
    struct Strip {
        std::array<dvec3, 2> fromWorld, toWorld; ///< of P and of P', as it is drawn
        std::array<std::optional<Hit>, 2> hits;  ///< on the way
        bool isBorder = false;                   ///< its first end is a vertex
    };
    [[nodiscard]] dvec3 away(const dvec3& placeWorld) const; ///< unit, from the light
    [[nodiscard]] std::optional<Hit> firstHit(const dvec3& fromWorld, const dvec3& wayWorld, double most) const;
    [[nodiscard]] bool onOnePlane(const std::optional<Hit>& a, const std::optional<Hit>& b) const;
    void findReceivers();
    void findStrips();
    void addStrips(const VolumeProbe::Caster::SilhouetteEdge& edge, double from, double to, int depth);
    void addShadow(const std::array<dvec3, 3>& cornersWorld, int depth);
    [[nodiscard]] double lengthOf(std::uint32_t vertex) const; ///< metres from P to P'; infinite: no end
    void chooseView(const dvec3& eyeWorld, bool hasEnds);
    [[nodiscard]] std::vector<dvec3> seenPlaces(const dvec3& middleWorld) const;
    void placeLight(double size, const dvec3& middleWorld);
    void drawBeyond(drawing::Drawing& drawing) const;
    void drawBottom(drawing::Drawing& drawing, double opacity) const;
    void drawStrips(drawing::Drawing& drawing, bool front, double opacity) const;
    [[nodiscard]] bool showsOutside(const Strip& strip) const;

    const scene::Scene& scene_;
    const CasterSolid& solid_;
    drawing::Box area_;
    double size_ = 0;   ///< metres across the caster
    double cutOff_ = 0; ///< metres that are drawn of an extruded vertex at most
    bool isCutOff_ = false;
    dvec3 lightWorld_{0.0}; ///< where it is drawn
    bool lightIsNear_ = false;
    struct Triangle {
        CasterSolid::Corners cornersWorld;
        std::size_t object;
    };
    std::vector<Triangle> others_; ///< of all other objects
    std::vector<Strip> strips_;
    std::vector<dvec3> curveWorld_;
    std::vector<dvec3> shadowWorld_; ///< three for each triangle
    std::string receiver_;
    scene::Bounds shownWorld_; ///< the caster and its shadow, and a little around them
    std::optional<SpaceView> view_;
};

} // namespace shadowlab::figures
