// A small renderer of another make, with the usual mistakes behind switches. It shares nothing with the program: rays by Moeller and
// Trumbore, a shadow map, and stencil counts of shadow volumes, all in plain loops.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "tests/foreign/foreign_scenes.h"

namespace foreign_renderer {

enum class Method { rays, map, zfail, zpass };
enum class Curve { srgb, linear, power22, twice };

struct Settings {
    int width = 320, height = 180;
    Method method = Method::rays;
    Vec lightOffset{0, 0, 0};     ///< metres; of a sun it is added to the direction
    double centre = 0.5;          ///< of a pixel
    bool flipRows = false, flipColumns = false;
    Curve curve = Curve::srgb;

    double bias = 0;              ///< metres along the ray: of the map, or where shadow rays begin
    int texels = 1024;            ///< on a side of the map
    bool frontCap = true, backCap = true;
    bool asksGreaterZero = false; ///< of the stencil; else other than zero
    bool onlyFrontSides = false;  ///< of the volumes: back faces are culled
    bool onlyBackSides = false;

    bool cullsCasters = false;    ///< triangles that turn their back to the light cast no shadow
    bool cullsView = false;       ///< nor are those seen that turn it to the eye
    bool reversed = false;        ///< fronts are taken for backs
    bool normalsToViewer = true;  ///< else only fronts are lit
    int withoutThing = -1;        ///< that casts no shadow
    int onlyThing = -1;           ///< that alone casts shadows
    bool selfShadows = true;      ///< else a thing casts no shadow on itself; of rays
    double mapPart = 1;           ///< of the map's width that there is
    bool darkOutside = false;     ///< of the map; else lit
    bool raysInMap = false;       ///< rays within the map instead of its depths
    double coneDegrees = 360;     ///< between opposite sides of the light's cone, about the way to the target
    double lightNear = 0;         ///< metres, of rays: casters nearer to the light cast no shadow
    double lightFar = 1e30;       ///< metres, of rays: what lies farther from the light is lit
    int samples = 1;              ///< n x n a pixel
};

/// Grey, rows from the top, one byte a pixel.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> grey;
};
struct Pictures {
    Picture visibility, shaded, unshadowed;
};

Pictures render(const Scene& scene, const Settings& settings);

} // namespace foreign_renderer
