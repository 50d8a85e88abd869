// The caster that a figure of shadow volumes is about: its triangles in the world, and the side that each turns to the light.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/figures/figures.h"
#include "app/figures/space_view.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

struct CasterSolid {
    const scene::Object* object = nullptr;
    const VolumeProbe::Caster* caster = nullptr;
    std::vector<dvec3> verticesWorld;
    scene::MeshTopology topology;
    dvec4 lightWorld{0.0}; ///< homogeneous

    using Corners = std::array<dvec3, 3>;
    [[nodiscard]] std::size_t triangles() const { return object->mesh->triangles.size(); }
    [[nodiscard]] Corners corners(std::size_t triangle) const;
    /// P, in the middle of the polygon.
    [[nodiscard]] dvec3 centre(std::size_t triangle) const;
    /// N, unit, to the side from which the corners run counter-clockwise.
    [[nodiscard]] dvec3 normal(std::size_t triangle) const;
    /// L = P_L - P, metres; of a directional light the unit direction toward it.
    [[nodiscard]] dvec3 toLight(const dvec3& placeWorld) const { return dvec3(lightWorld) - lightWorld.w * placeWorld; }
    [[nodiscard]] double cosine(std::size_t triangle) const; ///< N.L, as it is written down
    [[nodiscard]] bool facesLight(std::size_t triangle) const { return caster->facing[triangle] > 0; }
    [[nodiscard]] bool isClosed() const;
    /// "m", or nothing where L is a direction.
    [[nodiscard]] const char* unit() const { return lightWorld.w == 0 ? "" : " m"; }
};

/// What the pixel shows, or else what shadows it; the other way round where `shadowing`. Throws Error (badInput) where there is
/// neither.
CasterSolid casterSolid(const FigureSource& source, bool shadowing);

/// The triangle of that object which lies nearest to the picked pixel's point.
std::size_t nearestTriangle(const CasterSolid& solid, const dvec3& pointWorld);

/// The colours of a solid's triangles: of those that face the light, and of the others.
struct SideColors {
    std::string toward, away;
};
/// By the side that the light sees. `paleness` 0..1: how far toward white.
SideColors facingColors(double paleness);
/// By what they are of a shadow volume: those that face the light are its top cap, in the colour that the outside view gives it. The
/// others are grey: its bottom cap is where they have been moved to.
SideColors capColors(double paleness);

/// Paints triangles of the solid from back to front. Edges of coarse meshes are drawn.
void drawTriangles(drawing::Drawing& drawing, const SpaceView& view, const CasterSolid& solid,
                   std::span<const std::size_t> triangles, const SideColors& colors);

/// Is anything of these triangles on the way from the place to the viewer?
bool isHidden(const CasterSolid& solid, const dvec3& placeWorld, const dvec3& towardViewerWorld);

/// A colour mixed with white: "#rrggbb".
std::string paleColor(const vec3& linear, double paleness);

/// The light, where it is drawn, with its letter.
void drawLightSign(drawing::Drawing& drawing, drawing::Labels& labels, const SpaceView& view, const dvec3& drawnWorld,
                   const std::string& rest);

} // namespace shadowlab::figures
