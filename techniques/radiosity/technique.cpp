// Radiosity: what diffuse surfaces send each other (Goral, Torrance, Greenberg and Battaile, "Modeling the Interaction of Light
// Between Diffuse Surfaces", SIGGRAPH 1984).
//
// Here is what it is computed with. Faces (faces.h) are cut into patches (patches.h); form factors between them are closed forms
// (point_form_factor.h, rectangle_exchange.h) or quadrature (polygon_exchange.h), less what stands in between (occlusion.h,
// visible_exchange.h), all together an exchange matrix (exchange_builder.h, exchange_matrix.h); the equations (problem.h) are
// solved in six ways, with a bound of the error (solvers.h). No technique draws with it: the list is empty.
// SPDX-License-Identifier: MIT
#include "techniques/technique.h"

namespace shadowlab::radiosity {

std::span<const TechniqueInfo> techniques() { return {}; }

} // namespace shadowlab::radiosity
