// Ray tracing in words: its passes, in the order they are drawn, and its stages.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/ray_tracing/structure_stages.h"

namespace shadowlab::ray_tracing {

inline constexpr PassInfo kPasses[] = {
    {"id-buffer", "Draw the number of the triangle that each pixel shows",
     "The rasteriser finds what eye rays would find; each ray only checks that it hits the triangle it is told. Only "
     "with "
     "receivers = id-buffer.",
     "depth test LESS, depth write on; the numbers are read back", false, "primary-hits"},
    {"visibility", "Send a ray from the eye through every pixel, and from where it ends a ray to every light",
     "The nearest triangle that the eye ray hits is what the pixel shows. If the ray to a light hits anything on its "
     "way, "
     "whatever that is and however far, the point is in shadow: the first hit is enough.",
     "none: the processor traces, on all cores, 64 neighbouring rays at a time", false, "shadow-rays"},
    {"areas", "Find how much of the light's area every point sees, and what that brings it",
     "What is seen of the light is cut along the edges of what stands before it, and each piece is integrated in "
     "closed "
     "form. Only with soft-shadows = analytic.",
     "none: the processor cuts, 64 neighbouring points together", true, "visibility"},
    {"lights-off", "Show what is seen with all lights off", "Emission and ambient light are counted here, once.",
     "none: the processor shades; the picture is uploaded", false},
    {"light", "Add the light where its ray has arrived",
     "The same shading as in every other technique; only the question who is in shadow is answered in another way.",
     "none: the processor shades; the picture is uploaded", true},
    {"trees", "Follow the rays that mirrors and glass send on, and add what they bring",
     "At every surface a ray splits into a reflection and a refraction ray; their intensities are added up from the "
     "ends of "
     "the tree to its root. Pixels that show neither mirror nor glass stay as they are.",
     "none: the processor traces and shades; the picture is uploaded", false, "tree-depth"},
    {"samples", "Do all of it again, many times for each pixel, with rays that chance has spread, and take the mean",
     "Over the pixel: smooth edges. Over the lens: what is out of focus. Over the light: penumbrae. Over a lobe: gloss "
     "and translucency. Over the time that the shutter is open: motion blur. Only with samples above 1.",
     "none: the processor traces and shades; the picture is uploaded", false, "samples-per-pixel"},
};

inline constexpr StageInfo kStages[] = {
    {"primary-hits", "Where eye rays end: distance from the eye", StageKind::scalar, false},
    {"lights-off", "Scene with lights off", StageKind::radiance, false},
    {"shadow-rays", "What came of the shadow rays", StageKind::swatches, true},
    {"visibility", "Visibility of the light", StageKind::visibility, true},
    kTestsStage,
    kStructureStage,
    {"reflected", "What the reflection ray of each pixel adds", StageKind::radiance, false},
    {"transmitted", "What the refraction ray of each pixel adds", StageKind::radiance, false},
    {"tree-depth", "Levels of rays in the tree of each pixel", StageKind::scalar, false},
    {"penumbra", "Lit, penumbra and umbra: all, a part, or nothing of the light is seen", StageKind::swatches, true},
    {"samples-per-pixel", "How many samples each pixel got", StageKind::scalar, false},
};

} // namespace shadowlab::ray_tracing
