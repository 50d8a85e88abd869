// SPDX-License-Identifier: MIT
#include "techniques/radiosity/params.h"

#include <cmath>

namespace shadowlab::radiosity {

namespace {

// With so many the matrix alone takes 800 MB.
constexpr int kMostPatches = 10000;
constexpr int kMostSteps = 1000000;
constexpr int kMostRounds = 8;       // each adds up to half as many patches: the budget is used up by then
constexpr int kMostPoints = 4000000; // 64 MB for each light

/// One of the powers of two from `least` to `most`. Half of a hemicube's side is the height of a side face, so it must be even.
params::Param powerOfTwo(std::string id, int& field, int least, int most, std::string help) {
    params::Param param;
    param.id = std::move(id);
    param.help = std::move(help);
    param.kind = params::Kind::choice;
    for (int value = least; value <= most; value *= 2)
        param.choices.push_back(std::to_string(value));
    param.maximum = static_cast<double>(param.choices.size()) - 1;
    param.get = [&field, least] { return std::log2(field / least); };
    param.set = [&field, least](double index) { field = least << static_cast<int>(index); };
    param.initial = param.get();
    return param;
}

} // namespace

params::ParamList describe(RadiosityParams& p) {
    using params::onlyIf;
    const auto hasHemicube = [&p] { return p.formFactors == RadiosityParams::FormFactors::hemicube; };
    const auto hasLightMap = [&p] { return p.display == RadiosityParams::Display::lightMap; };
    return {
        params::integer("patches", p.patches, 6, kMostPatches, "patches",
                        "At most so many, as far as the scene's faces allow; meshes that would take "
                        "more than six tenths of them are simplified for the exchange of light. Time and memory grow "
                        "with the square."),
        params::boolean("cut-at-contacts", p.cutAtContacts,
                        "Patches end where other things stand on them; false: light leaks under walls (teaching)."),
        onlyIf(
            [hasHemicube] { return !hasHemicube(); },
            params::integer("refine", p.refine, 0, kMostRounds, "rounds",
                            "A third of the patches is cut evenly; then, in so many rounds, those are cut again that "
                            "the light is uneven on, or the edge of a shadow goes through. With it, form factors are "
                            "found again when a light moves; 0: all are cut evenly.")),
        onlyIf([&p, hasHemicube] { return !hasHemicube() && p.refine > 0; },
               params::real("refine-threshold", p.refineThreshold, 0.001, 10, "",
                            "Patches that are wrong by less than this share of the mean radiosity are not cut again.")),
        params::choice("form-factors", p.formFactors, {"analytic", "hemicube"},
                       "Closed forms and Lambert's polygon formula, with lines between patches that see each other in "
                       "part; or drawn from the centre of each patch onto half a cube (Cohen and Greenberg 1985)."),
        onlyIf(hasHemicube, powerOfTwo("hemicube-side", p.hemicubeSide, 8, 1024,
                                       "Pixels along an edge of the hemicube's upper face.")),
        params::boolean("scale-rows", p.scaleRows,
                        "Form factors are scaled, symmetrically, until rows sum to 1 in a closed room, or to no more "
                        "than 1 in an open scene; by how much they change is said."),
        params::choice("surroundings", p.surroundings, {"background", "ambient", "dark"},
                       "What comes from where a patch sees no surface: what the eye sees there; the scene's ambient "
                       "light; or nothing. In a closed room it makes no difference."),
        params::choice("solver", p.solver,
                       {"direct", "jacobi", "gauss-seidel", "southwell", "shooting", "conjugate-gradients"},
                       "How the equations are solved; direct: up to 3000 patches."),
        params::real("tolerance", p.tolerance, 1e-12, 1, "",
                     "Solved when no radiosity is certainly farther off than this share of the largest."),
        params::integer("steps", p.steps, 0, kMostSteps, "steps",
                        "The solver stops after so many, sweeps or shots; 0: when it is within the tolerance."),
        params::integer("steps-per-picture", p.stepsPerPicture, 0, kMostSteps, "steps",
                        "So many steps between two pictures of the window: the room brightens while one looks on; "
                        "0: as many as there is time for."),
        onlyIf(
            [&p] { return p.solver == SolverKind::shooting; },
            params::boolean("ambient-term", p.ambientTerm,
                            "While shooting, what is still unshot is shown as if it were everywhere alike (Cohen and "
                            "others 1988); false: the room brightens shot by shot.")),
        params::choice("display", p.display, {"flat", "interpolated", "light-map"},
                       "One radiosity for each patch; interpolated between corners of patches; the same, but with the "
                       "light that comes straight from lights found at many points of each patch."),
        onlyIf(hasLightMap,
               params::integer("light-map-points", p.lightMapPoints, 1, kMostPoints, "points",
                               "On all patches together, evenly; and one at every vertex of meshes that were "
                               "simplified.")),
        params::real("exposure", p.exposure, -10, 10, "stops", "Twice as bright for each."),
        params::integer("bounce", p.bounce, 0, 1000, "",
                        "Which reflection stage `bounce` shows: light that was reflected so many times."),
        params::integer(
            "from-patch", p.fromPatch, -1, kMostPatches, "",
            "Whose form factors the stage of that name shows while no pixel is picked; -1: of the patch that "
            "sends the most light."),
        params::integer(
            "to-patch", p.toPatch, -1, kMostPatches, "",
            "The other patch of the pair that a probe tells of while no second pixel is picked; -1: the one "
            "that gives it the most light."),
    };
}

} // namespace shadowlab::radiosity
