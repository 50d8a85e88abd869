// SPDX-License-Identifier: MIT
#include "techniques/planar/params.h"

#include <algorithm>
#include <iterator>

#include "techniques/foundation/scene/query/light_points.h"

namespace shadowlab::planar {

params::ParamList describe(PlanarParams& p) {
    using params::inGroup, params::onlyIf;
    params::ParamList all = {params::integer({"receivers", "Receiver planes"}, p.receivers, 0, kMostReceivers, "planes",
                                             "Most planes that receive shadows: the largest in the picture. Fewer "
                                             "where more than 63 of them overlap there.")};
    for (params::Param& param :
         scene::describe(p.lightPoints, "points",
                         "Shadows of a light with an area are drawn from so many points of it, and counted where they "
                         "overlap. 1: the hard shadow from its centre. Only while points darken once.")) {
        if (param.id == "light-samples") param.group.clear(); // soft shadows are a part of the lecture: basic
        all.push_back(onlyIf([&p] { return p.once; }, std::move(param)));
    }
    params::ParamList drawing = {
        params::boolean({"clip", "Clip casters"}, p.clip,
                        "Project only what lies between light and plane; false: anti-shadows of what lies beyond the "
                        "light or behind the plane (teaching)."),
        inGroup(
            params::kTeachingSwitches,
            params::boolean({"divide", "Divide by w before drawing"}, p.divide,
                            "Divide a projected vertex by its w before it is drawn, as on paper: a triangle that "
                            "reaches the light's height has a vertex at infinity, and is lost or torn (teaching).")),
        params::boolean({"stencil", "Stencil"}, p.stencil,
                        "Draw shadows only on the pixels of their plane; false: over everything that is not nearer, "
                        "also beyond the plane's edge (teaching)."),
        onlyIf([&p] { return !p.stencil; },
               inGroup(params::kTeachingSwitches,
                       params::real({"offset", "Depth offset"}, p.offset, 0, 1000000, "steps of depth",
                                    "Without stencil: how much nearer to the eye projected faces are drawn; 0: they "
                                    "fight with the plane for depth (teaching)."))),
        params::boolean({"once", "Darken once"}, p.once,
                        "A point under several projected faces is in shadow once; false: each face halves its "
                        "intensity again, the ambient light's as well (teaching)."),
        inGroup(params::kExpert, params::boolean({"cull", "Cull casters"}, p.cull,
                                                 "Leave out casters and faces whose shadow cannot be seen, and pixels "
                                                 "that none can reach: saves time, the picture is the same.")),
    };
    std::ranges::move(drawing, std::back_inserter(all));
    return all;
}

} // namespace shadowlab::planar
