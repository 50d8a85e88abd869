// Exercises about rays, their trees, and the samples of a pixel.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "app/course/exercises/kinds.h"
#include "app/course/exercises/squared_paper.h"

namespace shadowlab::course {

namespace {

/// Turns the two axes of a plane into two of space.
dvec3 inSpace(dvec2 v, bool alongZ) { return alongZ ? dvec3(0, v.y, v.x) : dvec3(v.x, v.y, 0); }

/// What a ray brings back: I = I_own + k_r I_R + k_t I_T.
double combined(double own, double reflectivity, double transparency, double reflected, double transmitted) {
    return own + reflectivity * reflected + transparency * transmitted;
}

dvec3 reflectedRay(const dvec3& u, const dvec3& normal) { return u - 2 * glm::dot(u, normal) * normal; }

/// `ratio`: of the index on the ray's side to that beyond, less than 1.
dvec3 refractedRay(const dvec3& u, const dvec3& normal, double ratio) {
    const double cosIncident = -glm::dot(u, normal),
                 cosBeyond = std::sqrt(1 - ratio * ratio * (1 - cosIncident * cosIncident));
    return ratio * u - (cosBeyond - ratio * cosIncident) * normal;
}

/// The rays of a tree in which every ray meets a surface that splits it, until the deepest level.
long countedRays(int levels) { return levels == 0 ? 1 : 1 + 2 * countedRays(levels - 1); }

} // namespace

Exercise askForReflection(Chance& chance) {
    const bool alongZ = chance.coin();
    const std::vector<dvec2> directions{{0.6, -0.8},   {0.8, -0.6},    {-0.6, -0.8},  {-0.8, -0.6},  {0, -1},
                                        {0.28, -0.96}, {-0.28, -0.96}, {0.96, -0.28}, {-0.96, -0.28}};
    const std::vector<dvec2> normals{{0, 1},      {0.6, 0.8},   {-0.6, 0.8},  {0.8, 0.6},
                                     {-0.8, 0.6}, {0.28, 0.96}, {-0.28, 0.96}};
    dvec2 flatU, flatN;
    do {
        flatU = chance.oneOf(directions);
        flatN = chance.oneOf(normals);
    } while (glm::dot(flatU, flatN) > -0.25 || glm::dot(flatU, flatN) < -0.97);
    const dvec3 u = inSpace(flatU, alongZ), normal = inSpace(flatN, alongZ), reflection = reflectedRay(u, normal);
    Exercise exercise;
    exercise.given = "A ray of the direction u = " + printed(u) +
                     " meets a mirror whose normal there is $\\mathbf{N}$ = " + printed(normal) +
                     ". Both are unit vectors.";
    exercise.questions = {"What is the cosine of the angle of incidence?",
                          "Find the direction R of the reflected ray."};
    exercise.answers = {printed(-glm::dot(u, normal)), "R = " + printed(reflection)};
    exercise.working = "$\\cos\\theta_i = -u \\cdot \\mathbf{N}$ and $R = u + 2 \\cos\\theta_i \\mathbf{N}$. R has the "
                       "length 1 again.";
    exercise.mistake = "u points toward the surface, so $u \\cdot \\mathbf{N}$ is negative.";
    addVector(exercise.data, "u", u);
    addVector(exercise.data, "N", normal);
    addVector(exercise.results, "R", reflection);
    exercise.results.push_back({"cosine", -glm::dot(u, normal)});
    return exercise;
}

Exercise askForRefraction(Chance& chance) {
    // Sine of incidence, and an index for which the other sine is a short number.
    struct Pair {
        double sine, index;
    };
    const auto [sine, index] = chance.oneOf(std::vector<Pair>{{0.6, 1.5},
                                                              {0.6, 1.25},
                                                              {0.6, 1.2},
                                                              {0.6, 1.6},
                                                              {0.8, 1.6},
                                                              {0.8, 1.25},
                                                              {0.8, 1.28},
                                                              {0.96, 1.6},
                                                              {0.96, 1.2},
                                                              {0.96, 1.5},
                                                              {0.96, 1.28},
                                                              {0.96, 1.25},
                                                              {0.28, 1.4},
                                                              {0.28, 1.25},
                                                              {0.28, 1.6},
                                                              {0.28, 1.12}});
    const bool alongZ = chance.coin(), toward = chance.coin();
    const dvec3 u = inSpace({toward ? sine : -sine, -std::sqrt(1 - sine * sine)}, alongZ), normal(0, 1, 0);
    const dvec3 refraction = refractedRay(u, normal, 1 / index);
    const double limit = glm::degrees(std::asin(1 / index));
    Exercise exercise;
    exercise.given = "A ray of the direction u = " + printed(u) +
                     " comes from air and meets a clear body of the index of refraction " + printed(index) +
                     ". The normal is $\\mathbf{N}$ = " + printed(normal) + ".";
    exercise.questions = {"Find the direction T of the refracted ray.",
                          "From within, at which angle of incidence does total reflection begin?"};
    exercise.answers = {"T = " + printed(refraction), printed(limit) + " degrees"};
    exercise.working = "With $\\eta = 1 / " + printed(index) +
                       "$: $\\cos\\theta_r = \\sqrt{1 - \\eta^2 (1 - \\cos^2\\theta_i)}$ and $T = \\eta u - "
                       "(\\cos\\theta_r - \\eta \\cos\\theta_i) \\mathbf{N}$. "
                       "Total reflection begins where $\\sin\\theta = \\eta$.";
    exercise.mistake =
        "$\\eta$ is the index on the ray's own side over that beyond: less than 1 on the way out of air.";
    addVector(exercise.data, "u", u);
    exercise.data.push_back({"index", index});
    addVector(exercise.results, "T", refraction);
    exercise.results.push_back({"limit", limit});
    return exercise;
}

Exercise askForTreeSize(Chance& chance) {
    const int levels = chance.between(3, 12), lights = chance.between(2, 9), side = chance.between(2, 8);
    const long rays = countedRays(levels);
    Exercise exercise;
    exercise.given = "Every ray of a pixel's tree meets a surface that reflects and refracts. The tree has " +
                     std::to_string(levels) + " levels below the eye ray. The scene has " + std::to_string(lights) +
                     " lamps, each a point.";
    exercise.questions = {"How many rays has the tree, the eye ray among them?",
                          "How many shadow rays are sent, one to each lamp from every surface that is met?",
                          "How many rays of all kinds does a pixel take with " + std::to_string(side) + " x " +
                              std::to_string(side) + " samples?"};
    exercise.answers = {std::to_string(rays), std::to_string(rays * lights),
                        std::to_string(rays * (1 + lights) * side * side)};
    exercise.working = "$1 + 2 + 4 + ... + 2^{" + std::to_string(levels) + "} = 2^{" + std::to_string(levels + 1) +
                       "} - 1$. Each of these rays meets one surface. All of it is done again for each sample.";
    exercise.mistake = "$2^{" + std::to_string(levels) + "}$ is the deepest level alone.";
    exercise.data = {{"levels", double(levels)}, {"lights", double(lights)}, {"side", double(side)}};
    exercise.results = {{"rays", double(rays)},
                        {"shadowRays", double(rays * lights)},
                        {"all", double(rays * (1 + lights) * side * side)}};
    return exercise;
}

Exercise askForIntensity(Chance& chance) {
    const auto tenths = [&](int least, int most) { return chance.between(least, most) / 10.0; };
    // The coefficients of a surface add up to less than 1.
    const double kr1 = tenths(1, 5), kt1 = tenths(1, 4), kr2 = tenths(1, 5), kt2 = tenths(1, 4);
    const double own1 = tenths(0, 4), own2 = tenths(0, 4), seenR = tenths(1, 9), seenRR = tenths(1, 9),
                 seenRT = tenths(1, 9);
    const double second = combined(own2, kr2, kt2, seenRR, seenRT), first = combined(own1, kr1, kt1, second, seenR);
    Exercise exercise;
    exercise.given =
        "The eye ray meets surface 1: $k_r$ = " + printed(kr1) + ", $k_t$ = " + printed(kt1) + ", and " +
        printed(own1) +
        " is what the lamps themselves make of it. Its reflected ray meets surface 2: $k_r$ = " + printed(kr2) +
        ", $k_t$ = " + printed(kt2) + ", and " + printed(own2) +
        " from the lamps. The refracted ray of surface 1 brings back the intensity " + printed(seenR) +
        ", the reflected ray of surface 2 " + printed(seenRR) + ", and the refracted ray of surface 2 " +
        printed(seenRT) + ".";
    exercise.questions = {"Draw the tree of rays. Which intensity does surface 2 send back?",
                          "Which intensity does the pixel get?"};
    exercise.answers = {printed(second), printed(first)};
    exercise.working = "$I = I_{own} + k_r I_R + k_t I_T$, from the leaves of the tree to its root.";
    exercise.mistake =
        "The coefficients of surface 1 apply to all that comes back from surface 2, also to what the lamps make of it.";
    exercise.data = {{"kr1", kr1},   {"kt1", kt1},          {"own1", own1},         {"kr2", kr2},          {"kt2", kt2},
                     {"own2", own2}, {"refracted1", seenR}, {"reflected2", seenRR}, {"refracted2", seenRT}};
    exercise.results = {{"second", second}, {"pixel", first}};
    return exercise;
}

Exercise askForShades(Chance& chance) {
    const int side = chance.oneOf(std::vector<int>{3, 4, 5});
    // The edge crosses the pixel's upper and lower border, at tenths; no sample is nearer to it than a fiftieth of the pixel.
    double above = 0, below = 0;
    int black = 0;
    bool isClear = false;
    while (!isClear) {
        above = chance.between(1, 9) / 10.0, below = chance.between(1, 9) / 10.0;
        isClear = above != below && std::abs(above + below - 1) > 0.05; // nor the one sample in the middle
        black = 0;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const double x = (column + 0.5) / side, edge = above + (below - above) * (row + 0.5) / side;
                isClear = isClear && std::abs(x - edge) > 0.02;
                black += x < edge;
            }
    }
    const double share = double(black) / (side * side), exact = (above + below) / 2;
    Exercise exercise;
    exercise.given = "A pixel is crossed by the straight edge of a shadow. What lies to the left of it is in shadow "
                     "(0), to the right lit (1). Along the upper border of the pixel the edge is at " +
                     printed(above) + " of its width from the left, along the lower border at " + printed(below) +
                     ". The dots are " + std::to_string(side) + " x " + std::to_string(side) +
                     " samples, in the middles of their cells.";
    exercise.questions = {"Draw the edge. How many samples are in shadow, and which value does the pixel get?",
                          "Which value would it get with one sample in its middle, and which would be exact?",
                          "How many shades can pixels have with so many samples?"};
    exercise.answers = {std::to_string(black) + " in shadow: " + printed(1 - share),
                        std::string(0.5 < exact ? "0" : "1") + "; exact is " + printed(1 - exact),
                        std::to_string(side * side + 1)};
    exercise.working = "In the middle row of the pixel the edge is at " + printed(exact) +
                       ". What is left of it is a trapezium of the area (" + printed(above) + " + " + printed(below) +
                       ") / 2. Of N samples none to all may be lit: N + 1 shades.";
    exercise.mistake = "N samples do not make N shades.";
    constexpr double kSide = 420, kAround = 50;
    drawing::Drawing pixel({kSide + 2 * kAround, kSide + 2 * kAround});
    for (int i = 0; i <= side; ++i) {
        const double at = kAround + kSide * i / side;
        const drawing::Stroke stroke{i == 0 || i == side ? "#1a1a1a" : "#c8c8c8", i == 0 || i == side ? 3.0 : 1.5};
        pixel.line({kAround, at}, {kAround + kSide, at}, stroke);
        pixel.line({at, kAround}, {at, kAround + kSide}, stroke);
    }
    for (int tenth = 0; tenth <= 10; ++tenth)
        for (const double border : {kAround, kAround + kSide}) {
            const double x = kAround + kSide * tenth / 10;
            pixel.line({x, border - 7}, {x, border + 7}, {"#1a1a1a", 2});
            if (tenth % 5 == 0)
                pixel.text({x, border == kAround ? border - 14 : border + 32}, printed(tenth / 10.0),
                           {.size = 20, .anchor = drawing::Anchor::middle, .hasRim = false});
        }
    for (int i = 0; i < side * side; ++i)
        pixel.circle(dvec2(kAround) + kSide / side * (dvec2(i % side, i / side) + 0.5), 6, "#0072b2", {"#0072b2", 1});
    exercise.figure = {pixel, "A pixel with its samples, and tenths of its width along the upper and the lower border"};
    exercise.data = {{"side", double(side)}, {"above", above}, {"below", below}};
    exercise.results = {{"black", double(black)},
                        {"value", 1 - share},
                        {"one", 0.5 < exact ? 0.0 : 1.0},
                        {"exact", 1 - exact},
                        {"shades", double(side * side + 1)}};
    return exercise;
}

} // namespace shadowlab::course
