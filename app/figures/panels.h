// The panels of a pixel's drawing.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/drawing/labels.h"
#include "app/figures/pixel_diagram.h"
#include "app/figures/rays/shown_tree.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/probed/map_probe.h"
#include "techniques/probed/patch_exchange.h"

namespace shadowlab::figures {

// Type is 1/45 of a slide's height, which is read from the last row.
constexpr double kText = 24, kHeading = 30, kSheetRow = 32;

/// "0.0412", "1.3·10⁻⁶": four digits, those of the power of ten raised.
std::string fourDigits(double value);

/// Colour of a ray on white paper.
drawing::Stroke strokeOf(Probe::Role role);
/// "0.42 0.4 0.38": red, green and blue in three digits at most.
std::string colorNumbers(const dvec3& intensity);
/// Pixels of a section's or a solid's room that stay empty on all sides.
constexpr double kSectionBorder = 16;

/// "4.2 %"
std::string percent(double share);
/// "41.3\u00b0" of an angle in radians.
std::string degreesText(double angle);

/// "Paths of pixel rays": where they go in the scene, in the plane of incidence of the first surface.
void drawPaths(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const ShownTree& shown, const scene::Scene& scene,
               const image::Font& font);

/// "Ray-tracing tree": the same rays as edges between the surfaces that they meet, with intensities.
void drawTree(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const ShownTree& shown, const image::Font& font);
/// Pixels that the tree needs from top to bottom.
double treeHeight(const Probe& probe, const ShownTree& shown);

/// The vectors u, V, N, R, T, L, H at the first surface.
void drawVectors(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const image::Font& font);

/// "Form factor": the surfaces j and k as they lie in space, with their normals, the line r between their centres and the angles
/// at its ends, and beside them what share of one's light reaches the other. There must be a k.
void drawFormFactor(drawing::Drawing& drawing, const drawing::Box& area, const PatchExchange& exchange, const image::Font& font);

/// The numbers of it, a column of lines.
void writeFormFactor(drawing::Drawing& drawing, const drawing::Box& area, const PatchExchange& exchange, const image::Font& font);

/// "Radiosity of a Lambertian reflector": how much light the pixel's surface sends in which direction, and what it is made of.
/// `eyeWorld`: whose direction is shown where k lies in none that light is sent in.
void drawReflector(drawing::Drawing& drawing, const drawing::Box& area, const PatchExchange& exchange, const dvec3& eyeWorld,
                   const image::Font& font);

/// The figures of the techniques of direct light, in the plane through eye, light and point: of shadow volumes, of a shadow map, of
/// shadows projected onto a plane. hasSection() must hold, and the probe have the part that is named.
void drawVolume(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
                const image::Font& font);
void drawMap(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene, const image::Font& font);
/// The places in the map at which a filter compares; hasTaps() must hold.
bool hasTaps(const MapProbe& map);
void drawTaps(drawing::Drawing& drawing, const drawing::Box& area, const MapProbe& map);
void drawPlane(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
               const image::Font& font);
/// The same for a point that lies on no plane that receives: where the planes are that do.
void drawNoPlane(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
                 const image::Font& font);

} // namespace shadowlab::figures
