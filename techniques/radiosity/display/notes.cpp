// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/stages.h"

#include <algorithm>

#include "techniques/foundation/base/look.h"

namespace shadowlab::radiosity {

namespace {

std::string percent(double share) { return probeText(100 * share) + " %"; }

std::string colors(const dvec3& rgb) { return probeText(rgb.r) + ", " + probeText(rgb.g) + ", " + probeText(rgb.b); }

void noteRoom(Frame& frame, const Room& room, int budget) {
    frame.count("patches", static_cast<double>(room.patches().size()), budget, "of the budget");
    if (room.patches().empty())
        frame.note("patches", "none: no side of a surface lies before another that light can reach", look::kLit);
    if (room.usesImportance())
        frame.note("importance", percent(room.importance().shareOfCoarse()) + " of the surfaces matter little to the picture: their patches are larger",
                   look::kLit);
    else if (!room.importance().parts().empty())
        frame.note("importance", "not used: the budget is too small to divide faces by it", look::kLit);
    if (room.simple().trianglesAfter < room.simple().trianglesBefore)
        frame.note("meshes",
                   "light is exchanged by " + std::to_string(room.simple().trianglesAfter) + " triangles in place of " +
                       std::to_string(room.simple().trianglesBefore),
                   look::kLit);
    if (room.coveredPatches() > 0)
        frame.note("covered",
                   std::to_string(room.coveredPatches()) + " patches left out: they lie under or in a closed body",
                   look::kLit);
    if (room.foldedPatches() > 0)
        frame.note("folded",
                   std::to_string(room.foldedPatches()) +
                       " patches left out: coarser meshes fold onto themselves there",
                   look::kLit);
}

void noteFormFactors(Frame& frame, const PreparedExchange& exchange) {
    const auto count = [&](VisibleExchange::Kind kind) { return static_cast<double>(exchange.counts.of(kind)); };
    using enum VisibleExchange::Kind;
    const double facing = count(full) + count(partial) + count(hidden);
    if (facing > 0) {
        frame.count("pairs-seen-fully", count(full), facing, "pairs that face each other");
        frame.count("pairs-seen-in-part", count(partial), facing, "pairs that face each other");
    }
    frame.count("matrix-bytes", static_cast<double>(exchange.matrix.bytes()));
    if (exchange.rowSums.empty()) return;
    const auto [least, most] = std::ranges::minmax_element(exchange.rowSums);
    frame.note("row sums",
               probeText(*least) + " to " + probeText(*most) +
                   (exchange.isClosed ? ": a closed room" : ": an open scene, the rest escapes") +
                   (exchange.isClosed || exchange.patchesInClosedRooms == 0
                        ? ""
                        : "; " + std::to_string(exchange.patchesInClosedRooms) +
                              " patches lie in rooms from which nothing escapes"),
               look::kLit);
    if (const double deviation = std::ranges::max(exchange.rowDeviations); deviation > 0)
        frame.note("lines between patches",
                   "leave row sums uncertain by " + probeText(deviation) + " at most (one standard deviation)",
                   look::kLit);
    if (exchange.isScaled)
        frame.note("scaling", "changed form factors by " + percent(exchange.scalingChanged) + " at most", look::kLit);
    frame.note("reciprocity",
               "A_j F_jk and A_k F_kj differ by " + probeText(exchange.reciprocityResidual) + " of themselves",
               look::kLit);
}

void noteSolution(Frame& frame, const Showing& showing) {
    const Solver* solver = showing.balance.solver();
    if (!solver) return;
    const dvec3 bound = solver->errorBound().largest;
    frame.count("steps", static_cast<double>(solver->steps()));
    frame.note("solution",
               std::string(nameOf(showing.params.solver)) + ", " + std::to_string(solver->steps()) +
                   (solver->steps() == 1 ? " step" : " steps") + ": no radiosity is farther off than " + colors(bound) +
                   " W/m^2",
               look::kLit);
    if (const auto unshot = solver->unshotPower()) frame.note("unshot", colors(*unshot) + " W", look::kLit);
    const EnergyBalance& energy = showing.balance.energy();
    frame.note("power",
               colors(energy.emitted) + " W from lights and surroundings, " + colors(energy.absorbed) + " absorbed, " +
                   colors(energy.escaped) + (showing.params.showsPixels() && showing.caughtByLamps > 0 ? " escaped or taken in by lamps" : " escaped"),
               look::kLit);
}

void noteError(Frame& frame, double share) {
    frame.count("patch-error-percent", 100 * share);
    frame.note("what is left",
               "patches of one value each are wrong by about " + percent(share) + " of the light, in the mean; the picture smooths it",
               look::kLit);
}

/// Lamps are no patches, and without lines past them in no light's way.
void noteLamps(Frame& frame, double caught, bool areInTheWay) {
    constexpr double kLeast = 0.001; // in a room of which surfaces reflect nine tenths that makes a hundredth
    if (caught < kLeast) return;
    frame.note("lamps",
               areInTheWay ? "they take in up to " + percent(caught) + " of what surfaces send"
                            : "reflected light goes through them: up to " + percent(caught) + " of what surfaces send would meet them",
               look::kLit);
}

/// Materials with properties that a Lambertian surface does not have.
void noteMaterials(Frame& frame) {
    std::string names;
    std::size_t count = 0;
    for (const scene::Material& material : frame.scene().materials) {
        if (material.specular == vec3(0.0f) && material.reflectivity == 0 && material.transparency == 0) continue;
        names += (count++ > 0 ? ", " : "") + material.name;
    }
    if (count > 0) frame.note("not dull", names + ": highlights, mirrors and glass are left out", look::kLit);
}

} // namespace

void publishNotes(const Showing& showing) {
    noteRoom(showing.frame, showing.cache.room(), showing.params.patches);
    noteFormFactors(showing.frame, showing.cache.exchange());
    noteSolution(showing.frame, showing);
    if (showing.patchError) noteError(showing.frame, *showing.patchError);
    noteLamps(showing.frame, showing.caughtByLamps, showing.params.showsPixels());
    noteMaterials(showing.frame);
}

} // namespace shadowlab::radiosity
