// SPDX-License-Identifier: MIT
#include <array>

#include "app/student/grading/families.h"

namespace shadowlab::student {

namespace {

// 76,800 pixels; the border of a patch is one row of pixels.
constexpr std::string_view kPatches =
    "patches that are divided otherwise differ along their borders: 2 % of the picture";

constexpr std::array kRadiosityCases = std::to_array<Case>({
    {"room-furnace", "a closed room: B = E / (1 - rho)", "4 5", 1500, kPatches, 3,
     "Every row of form factors sums to 1, and every patch gathers until nothing is added any more. Does the stage "
     "row-sums show 1?",
     Judged::picture},
    {"room-parallel", "the form factor of parallel patches", "1", 1500, kPatches, 2,
     "cos phi_j cos phi_k / (pi r^2), times both areas: is a cosine missing, or a power of r?", Judged::picture},
    {"room-corner", "the form factor of patches at right angles", "1", 1500, kPatches, 2,
     "Both cosines are those of angles with the normals, each of its own patch.", Judged::picture},
    {"room-screen", "what stands between two patches", "2", 1500, kPatches, 3,
     "Count the lines between the patches that are free, and divide by how many there are.", Judged::picture},
    {"room-areas", "A_j F_jk = A_k F_kj", "3", 1500, kPatches, 3,
     "F_jk is what is exchanged by the area of the patch that sends, j.", Judged::picture},
    {"room-lamp", "the energy emission rate E: light of a lamp", "4", 1500, kPatches, 3,
     "A lamp is no patch. What a patch reflects of its light is rho times the irradiance.", Judged::picture},
    {"room-sky", "an open place is closed by the background", "4", 1500, kPatches, 2,
     "What is missing to 1 in a row of form factors sees the background: pi times its intensity, times rho.",
     Judged::picture},
    {"room-colour", "reflected light has the colour of what reflected it", "5", 1500, kPatches, 2,
     "B_i = E_i + rho_i times what is gathered: rho is a colour, and is that of the patch that gathers.",
     Judged::picture},
});

} // namespace

std::span<const Case> radiosityCases() { return kRadiosityCases; }

} // namespace shadowlab::student
