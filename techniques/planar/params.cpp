// SPDX-License-Identifier: MIT
#include "techniques/planar/params.h"

#include <algorithm>
#include <iterator>

#include "techniques/foundation/scene/query/light_points.h"

namespace shadowlab::planar {

params::ParamList describe(PlanarParams& p) {
    using params::onlyIf;
    params::ParamList all = {params::integer(
        "receivers", p.receivers, 0, kMostReceivers, "planes",
        "At most so many planes receive shadows: the largest in the picture. Fewer where more than 63 lie "
        "one over the other.")};
    for (params::Param& param : scene::describe(
             p.lightPoints, "points",
             "Of a light with an area: the shadows from so many points of it are drawn, and counted where they "
             "overlap; 1: the hard shadow from its centre. Only with once."))
        all.push_back(onlyIf([&p] { return p.once; }, std::move(param)));
    params::ParamList drawing = {
        params::boolean("clip", p.clip,
                        "Flatten only what lies between light and plane; false: anti-shadows of what lies beyond the "
                        "light or behind the plane (teaching)."),
        params::boolean("divide", p.divide,
                        "Divide a flattened vertex by its weight before it is drawn, as on paper: what reaches up to "
                        "the light's height has a vertex at infinity, and is lost or torn (teaching)."),
        params::boolean("stencil", p.stencil,
                        "Draw on the plane's own pixels, without depth; false: over everything that is not nearer, "
                        "spilling past the plane's edge (teaching)."),
        onlyIf([&p] { return !p.stencil; },
               params::real("offset", p.offset, 0, 1000000, "steps of depth",
                            "Without stencil: how much nearer to the eye flattened faces are drawn; 0: they fight "
                            "with the plane for depth (teaching).")),
        params::boolean(
            "once", p.once,
            "A point under several faces is in shadow once; false: each face that falls on it halves what is "
            "there, the ambient light as well (teaching)."),
        params::boolean(
            "cull", p.cull,
            "Leave out casters whose shadow cannot reach a plane, or lies out of view, faces that others hide from "
            "the light, and pixels that no shadow can reach; the picture is the same."),
    };
    std::ranges::move(drawing, std::back_inserter(all));
    return all;
}

} // namespace shadowlab::planar
