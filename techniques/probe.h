// What a technique knows about one pixel: facts to print, rays and vectors to draw in the scene; where it follows rays
// that split, their tree; where patches send each other light, two of them; of a shadow what decided on it (shadow_probe.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/rays_probe.h"
#include "techniques/scene_shape.h"
#include "techniques/shadow_probe.h"

namespace shadowlab {

struct Probe {
    /// One line of what is known. Numbers are in `numbers` as well, with all their digits.
    struct Fact {
        std::string label, value, unit;
        std::vector<double> numbers{};
    };
    /// What a ray is sent for, and of a shadow ray what came of it.
    enum class Role { eye, reflection, refraction, arriving, blocked };
    /// A piece of a ray that is drawn as a line.
    struct Segment {
        std::string label;
        dvec3 fromWorld, toWorld;
        Role role = Role::arriving;
        bool isEndless = false; ///< it goes on where the line ends: it meets nothing, or the sun is nowhere
    };
    /// A unit vector at the first surface, such as the normal.
    struct Vector {
        std::string label; ///< one letter, as in the lecture
        dvec3 directionWorld;
    };
    /// A ray of a tree; parent is an index into `tree`, -1 at the root.
    struct Node {
        int parent;
        std::string label;
        std::vector<Fact> facts;
        // The rest is for drawings of the tree.
        Role role = Role::eye;
        std::string sign{};    ///< "R1": the reflection ray of surface S1
        std::string surface{}; ///< "S2": what it meets; empty: nothing
        std::string object{};  ///< of which that is the surface
        std::string end{};     ///< why it goes no farther; empty: it does
        int segment = -1;      ///< in `geometry`; -1: it was not sent
        int light = -1;        ///< of a shadow ray
        double share = 0;      ///< of the pixel that it carries where it begins
        dvec3 intensity{0.0};
        dvec3 normalWorld{0.0}; ///< N where it ends, on the side that it came from
    };
    /// A flat piece of a surface that sends light out in all directions, as a Lambertian one does.
    struct Patch {
        std::string object;              ///< of which it is a piece
        std::vector<dvec3> cornersWorld; ///< counter-clockwise seen from the front
        dvec3 centreWorld, normalWorld;  ///< its centroid; the front's side, unit
        double area = 0;                 ///< m^2
        dvec3 emission{0.0};             ///< E, W/m^2
        dvec3 reflectance{0.0};          ///< rho, 0..1
        dvec3 radiosity{0.0};            ///< B, W/m^2
    };
    /// The pixel's patch j, and another one that it exchanges light with.
    struct Exchange {
        Patch j;
        std::optional<Patch> k{};
        double formFactorJk = 0; ///< the share of what leaves j that reaches k, with what stands in between
        double formFactorKj = 0;
    };
    /// Some of the n equations of a room whose patches exchange light: B_i - rho_i sum of F_ik B_k = what i sends of its own.
    struct Equations {
        std::uint32_t count = 0;            ///< n
        std::vector<std::uint32_t> patches; ///< 1 ... n, rising: those whose rows and columns these are
        std::vector<dvec3> reflectance;     ///< rho_i
        std::vector<dvec3> emission;        ///< E_i, W/m^2, with what i reflects of light sources that are no patches
        std::vector<dvec3> radiosity;       ///< B_i, W/m^2
        std::vector<std::vector<double>> formFactors; ///< F_ik, of rows and columns as in `patches`
        std::vector<dvec3> fromOthers;                ///< sum of F_ik B_k over all other columns, W/m^2
    };
    std::vector<Fact> facts;
    std::vector<Segment> geometry;
    std::vector<Node> tree;
    std::vector<Vector> vectors;               ///< at the end of the eye ray
    std::optional<Exchange> exchange{};        ///< of a technique in which patches send each other light
    std::optional<Equations> equations{};      ///< of the same
    std::optional<RaysProbe> rays{};           ///< of one that sends several rays for a pixel
    std::optional<StructureProbe> structure{}; ///< of one that traces rays with volumes or cells
    std::optional<LightSection> section{};     ///< that the following are drawn in; none without a light
    std::optional<Decision> decision{};  ///< of a technique that decides on the spot whether a light reaches the pixel
    std::optional<VolumeProbe> volume{}; ///< of one that counts faces of volumes
    std::optional<MapProbe> map{};       ///< of one that asks a depth map
    std::optional<PlaneProbe> plane{};   ///< of one that flattens casters onto planes
    /// A pass of a frame, as often as it is drawn: with which light, and how many triangles it draws.
    struct DrawnPass {
        std::string id;
        int light = -1; ///< index; -1: of no light
        std::uint64_t triangles = 0;
        std::string what; ///< which, in a few words
    };
    std::vector<DrawnPass> passes;   ///< of the frame that the pixel is in, in order, of a technique that tells
    std::vector<SceneShape> visited; ///< what of the technique's own structures the eye ray passes through
};

/// Six digits, without regard to the locale, and without a sign where there is nothing.
std::string probeText(double number);
Probe::Fact probeFact(std::string label, double number, std::string unit = "");
Probe::Fact probeFact(std::string label, const dvec3& vector, std::string unit = "");
Probe::Fact probeCount(std::string label, std::uint64_t count, std::string unit = "");

} // namespace shadowlab
