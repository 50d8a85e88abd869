// SPDX-License-Identifier: MIT
#include "techniques/radiosity/params.h"

#include <cmath>

namespace shadowlab::radiosity {

namespace {

// With so many the matrix alone takes 800 MB.
constexpr int kMostPatches = 10000;
constexpr int kMostSteps = 1000000;
constexpr int kMostRounds = 8;       // each adds up to half as many patches: the budget is used up by then
constexpr int kMostGathered = 65536; // at 1280 x 720 some hours
constexpr int kMostPoints = 4000000; // 64 MB for each light

// Names of the groups.
constexpr std::string_view kPatchesGroup = "Patches", kFormFactorsGroup = "Form factor options",
                           kSolverGroup = "Solver options", kDisplayGroup = "Display",
                           kStagesGroup = "Stages and probes";

/// One of the powers of two from `least` to `most`. Half of a hemicube's side is the height of a side face, so it must be even.
params::Param powerOfTwo(params::Named id, int& field, int least, int most, std::string help) {
    std::vector<params::Named> choices;
    for (int value = least; value <= most; value *= 2)
        choices.emplace_back(std::to_string(value));
    return params::numberedChoice(
        std::move(id), [&field, least] { return static_cast<int>(std::log2(field / least)); },
        [&field, least](int index) { field = least << index; }, choices, std::move(help));
}

} // namespace

params::ParamList describe(RadiosityParams& p) {
    using params::inGroup, params::onlyIf;
    const auto hasHemicube = [&p] { return p.formFactors == RadiosityParams::FormFactors::hemicube; };
    const auto isSmooth = [&p] { return p.display == RadiosityParams::Display::interpolated; };
    const auto showsPixels = [&p, isSmooth] { return isSmooth() && p.direct == RadiosityParams::Direct::pixels; };
    const auto hasLightMap = [&p, isSmooth] { return isSmooth() && p.direct == RadiosityParams::Direct::lightMap; };
    return {
        params::integer(
            {"patches", "Number of patches"}, p.patches, 6, kMostPatches, "patches",
            "At most so many, as far as the scene's faces allow; time and memory grow with the square. Meshes that "
            "would need more than six tenths of them are simplified for the exchange of light."),
        inGroup(kPatchesGroup,
                params::boolean({"importance", "Finer where it matters to the eye"}, p.importance,
                                "Where the light that surfaces send hardly comes to what the eye sees, as in other rooms, patches are up to eight times as "
                                "long, so that more are left for the rest. They are then cut anew where the eye moves far.")),
        inGroup(params::kTeachingSwitches,
                params::boolean(
                    {"cut-at-contacts", "Cut patches at contacts"}, p.cutAtContacts,
                    "Patches end where other objects stand on them; false: light leaks under walls (teaching).")),
        onlyIf([hasHemicube] { return !hasHemicube(); },
               inGroup(kPatchesGroup,
                       params::integer(
                           {"refine", "Rounds of refinement"}, p.refine, 0, kMostRounds, "rounds",
                           "Cut patches again where the light on them is uneven or a shadow's edge crosses them; form "
                           "factors are then computed anew when a light moves. 0: all are cut evenly."))),
        onlyIf(
            [&p, hasHemicube] { return !hasHemicube() && p.refine > 0; },
            inGroup(kPatchesGroup,
                    params::real({"refine-threshold", "Refinement threshold"}, p.refineThreshold, 0.001, 10, "",
                                 "Patches whose error is below this share of the mean radiosity are not cut again."))),
        params::choice(
            {"form-factors", "Form factors"}, p.formFactors, {{"analytic", "closed form"}, "hemicube"},
            "Analytic: closed forms and Lambert's polygon formula, with rays between patches that see each other in "
            "part; hemicube: the scene drawn onto half a cube over each patch (Cohen and Greenberg 1985)."),
        onlyIf(hasHemicube,
               inGroup(kFormFactorsGroup, powerOfTwo({"hemicube-side", "Hemicube resolution"}, p.hemicubeSide, 8, 1024,
                                                     "Pixels along an edge of the hemicube's upper face."))),
        inGroup(kFormFactorsGroup,
                params::boolean({"scale-rows", "Scale rows to 1"}, p.scaleRows,
                                "Scale form factors, symmetrically, until each row sums to 1 in a closed room, or to "
                                "at most 1 in an open scene; the size of the change is noted.")),
        inGroup(kFormFactorsGroup,
                params::choice({"surroundings", "Light from outside"}, p.surroundings,
                               {{"background", "the background"}, {"ambient", "ambient light"}, {"dark", "none"}},
                               "What arrives from where a patch sees no surface: the background; the scene's ambient "
                               "light; or nothing. In a closed room it makes no difference.")),
        params::choice("solver", p.solver,
                       {{"direct", "direct (elimination)"},
                        {"jacobi", "Jacobi"},
                        {"gauss-seidel", "Gauss-Seidel (gathering)"},
                        {"southwell", "Southwell"},
                        {"shooting", "progressive shooting"},
                        {"conjugate-gradients", "conjugate gradients"}},
                       "How the radiosity equations are solved; direct: up to 3000 patches."),
        inGroup(kSolverGroup,
                params::real(
                    {"tolerance", "Solver tolerance"}, p.tolerance, 1e-12, 1, "",
                    "Solved when the proven error of every radiosity is below this share of the largest radiosity.")),
        params::integer(
            {"steps", "Solver steps"}, p.steps, 0, kMostSteps, "steps",
            "Stop after so many steps (sweeps over all patches, or shots); 0: when the error is within the tolerance."),
        inGroup(kSolverGroup,
                params::integer("steps-per-picture", p.stepsPerPicture, 0, kMostSteps, "steps",
                                "Steps between two pictures of the window, so that the class sees the room "
                                "brighten; 0: as many as there is time for.")),
        onlyIf(
            [&p] { return p.solver == SolverKind::shooting; },
            inGroup(kSolverGroup, params::boolean("ambient-term", p.ambientTerm,
                                                  "While shooting, show unshot radiosity as ambient light (Cohen and "
                                                  "others 1988); false: the room brightens shot by shot."))),
        params::choice({"display", "Shown as"}, p.display, {"interpolated", {"flat", "flat patches"}},
                       "Interpolated: between the corners of patches; flat: one radiosity for each patch, direct light included."),
        onlyIf(isSmooth,
               inGroup(kDisplayGroup,
                       params::choice(
                           {"direct", "Direct light"}, p.direct,
                           {{"pixels", "of each pixel, exactly"}, {"light-map", "in a light map"}, {"patches", "of patches"}},
                           "Where the light of the lights themselves is found, and the edges of their shadows with it. Pixels: "
                           "by rays, for each; light map: at many points of each patch; patches: one mean for each, as the "
                           "lecture has it, interpolated like all other light."))),
        onlyIf(showsPixels,
               inGroup(kDisplayGroup,
                       params::choice({"gather", "Final gather"}, p.gather,
                                      {{"none", "between patches"}, {"shared", "some pixels for all"}, {"pixels", "of each pixel"}},
                                      "Who collects the light that patches send by rays of its own, for contact shadows and "
                                      "corners: nobody, it is interpolated between patches; one pixel of 64, and for those that "
                                      "may not take that over others nearer to them; or each pixel, with noise that gets "
                                      "less while one looks on."))),
        onlyIf([&p, showsPixels] { return showsPixels() && p.gather != RadiosityParams::Gather::none; },
               inGroup(kDisplayGroup,
                       params::integer("gather-samples", p.gatherSamples, 1, kMostGathered, "rays",
                                       "Rays that a pixel collects light along. A quarter of the noise takes 16 times as many."))),
        onlyIf(hasLightMap,
               inGroup(kDisplayGroup,
                       params::integer("light-map-points", p.lightMapPoints, 1, kMostPoints, "points",
                                       "Points of the light map on all patches together; beside them one at "
                                       "every vertex of simplified meshes."))),
        inGroup(kDisplayGroup,
                params::real("exposure", p.exposure, -10, 10, "stops", "Each stop makes the picture twice as bright.")),
        inGroup(kStagesGroup, params::integer({"bounce", "Bounce shown"}, p.bounce, 0, 1000, "",
                                              "Stage bounce: light that was reflected exactly so many times.")),
        inGroup(kStagesGroup,
                params::integer({"from-patch", "Form factors from patch i"}, p.fromPatch, -1, kMostPatches, "",
                                "Stage form-factors, while no pixel is picked: the patch whose form factors "
                                "are shown; -1: the patch that sends the most light.")),
        inGroup(kStagesGroup,
                params::integer({"to-patch", "Form factor to patch k"}, p.toPatch, -1, kMostPatches, "",
                                "Probe, while no second pixel is picked: the other patch of the pair; -1: the "
                                "patch that gives it the most light.")),
    };
}

} // namespace shadowlab::radiosity
