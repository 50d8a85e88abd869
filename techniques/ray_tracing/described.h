// The passes of ray tracing in the order in which they are drawn, and its stages.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// The lecture's "Ray Casting Procedure", "Pixel Intensity Calculation" and "Distributed Ray-Tracing".
inline constexpr std::string_view kRayCastingSteps =
    "1. Cast pixel ray from projection reference point through pixel center.\n"
    "2. Each time a pixel ray intersects an object surface, it splits into two secondary rays: a reflection ray and a "
    "refraction ray. (No refraction ray for opaque object.)\n"
    "3. Repeat step 2 for each pixel ray. Each intersected surface is added to a binary ray-tracing tree.\n"
    "4. A pixel ray is terminated when it intersects no surfaces, intersects a light source that is not a reflecting "
    "surface, or the tree reaches maximum allowable depth.\n"
    "5. The tree is processed in bottom-up order: a ray that meets nothing has the background's intensity, one that "
    "meets a light source that of the light source.\n"
    "6. At each surface intersection, the intensities from reflection ray, refraction ray and all the light sources "
    "are accumulated for the parent ray.\n"
    "7. Pixel ray intensity is attenuated by the distance it travels. The pixel intensity is obtained at the root of "
    "the tree.\n"
    "8. Distributed: fire subpixel rays through jittered positions, and average the intensity of these rays.";

inline constexpr PassInfo kPasses[] = {
    {.id = "id-buffer",
     .title = "Draw the number of the triangle that each pixel shows",
     .why = "The rasteriser finds what eye rays would find; each ray only checks that it hits the triangle it is told. "
            "Only with receivers = id-buffer.",
     .glState = "depth test LESS, depth write on; the numbers are read back",
     .shownBy = "primary-hits",
     .pseudocodeLines = {1, 1},
     .anchors = "triangle-number"},
    {.id = "visibility",
     .title = "Send a ray from the eye through every pixel, and from where it ends a ray to every light",
     .why = "The nearest triangle that the eye ray hits is what the pixel shows. If the ray to a light hits anything "
            "on its way, whatever that is and however far, the point is in shadow: the first hit is enough.",
     .glState = "none: the processor traces, on all cores, 64 neighbouring rays at a time",
     .shownBy = "shadow-rays",
     .pseudocodeLines = {1, 1},
     .formula = "P = eye + t u, t the least for which a triangle is met\n"
                "visibility = 0 if the segment from P to the light meets any triangle, else 1",
     .anchors = "point-sees-light naive-hit[intersection=naive]"},
    {.id = "areas",
     .title = "Find how much of the light's area every point sees, and what that brings it",
     .why = "What is seen of the light is cut along the edges of what stands before it, and each piece is integrated "
            "in closed form. Only with soft-shadows = analytic.",
     .glState = "none: the processor cuts, 64 neighbouring points together",
     .perLight = true,
     .shownBy = "visibility",
     .formula = "E = L * integral over the seen part of the light of (n.l cos phi / d^2) dA",
     .anchors = "area-irradiance"},
    {.id = "lights-off",
     .title = "Show what is seen with all lights off",
     .why = "Emission and ambient light are counted here, once.",
     .glState = "none: the processor shades; the picture is uploaded",
     .formula = "I = emission + ambient * diffuse",
     .anchors = "shaded-lights-off"},
    {.id = "light",
     .title = "Add the light where its ray has arrived",
     .why =
         "The same shading as in every other technique; only the question who is in shadow is answered in another way.",
     .glState = "none: the processor shades; the picture is uploaded",
     .perLight = true,
     .pseudocodeLines = {6, 6},
     .formula = "I = I + visibility * color * E * (diffuse / pi + specular * (s + 8) / (8 pi) * (N.H)^s)",
     .anchors = "shade-lit shaded-lit"},
    {.id = "trees",
     .title = "Follow the rays that mirrors and glass send on, and add what they bring",
     .why = "At every surface a ray splits into a reflection and a refraction ray; their intensities are added up from "
            "the ends of the tree to its root. Pixels that show neither mirror nor glass stay as they are.",
     .glState = "none: the processor traces and shades; the picture is uploaded",
     .shownBy = "tree-depth",
     .pseudocodeLines = {2, 7},
     .formula = "I = attenuation * (own light + weight of I_R * I_R + weight of I_T * I_T)\n"
                "R = u - 2 (u.N) N",
     .anchors = "tree-grows tree-splits tree-evaluates"},
    {.id = "samples",
     .title = "Do all of it again, many times for each pixel, with rays that chance has spread, and take the mean",
     .why =
         "Over the pixel: smooth edges. Over the lens: what is out of focus. Over the light: penumbrae. Over a lobe: "
         "gloss and translucency. Over the time that the shutter is open: motion blur. Only with samples above 1.",
     .glState = "none: the processor traces and shades; the picture is uploaded",
     .shownBy = "samples-per-pixel",
     .pseudocodeLines = {8, 8},
     .formula = "I = sum of the samples' I / samples",
     .anchors = "eye-sample russian-roulette"},
};

inline constexpr StageInfo kTestsStage = {"intersection-tests",
                                          "Tests per pixel: volumes and triangles, eye ray and shadow rays together",
                                          StageKind::scalar, false};
inline constexpr StageInfo kStructureStage = {"structure", "The structure that spares rays most triangles",
                                              StageKind::swatches, false};

inline constexpr StageInfo kStages[] = {
    {"primary-hits", "Where eye rays end: distance from the eye", StageKind::scalar, false},
    {"lights-off", "Scene with lights off", StageKind::radiance, false},
    {"shadow-rays", "What came of the shadow rays", StageKind::swatches, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
    kTestsStage,
    kStructureStage,
    {"reflected", "Reflected light: what the reflection ray of each pixel adds", StageKind::radiance, false},
    {"transmitted", "Refracted light: what the refraction ray of each pixel adds", StageKind::radiance, false},
    {"tree-depth", "Depth of the tree: the levels of rays of each pixel", StageKind::scalar, false},
    {"penumbra", "Lit, penumbra and umbra: all, a part, or nothing of the light is seen", StageKind::swatches, true},
    {"samples-per-pixel", "How many samples each pixel got", StageKind::scalar, false},
};

} // namespace shadowlab::ray_tracing
