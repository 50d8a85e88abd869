// Form factors by hemicubes beside exact ones: time, and what is wrong with them, at several sizes of the picture.
//
// In a cube with 8 x 8 patches to a wall, where closed forms say everything:
//   pixels   against the exact form factor from the patch's centre: what is left is that of the pixels
//   in all   against the exact one from the whole patch: with what the centre errs by
// In the Cornell room: the time for all patches, hemicubes and exact exchange areas taking turns, medians of the rounds; how much
// A_i F_ij and A_j F_ji differ; and, row sums brought down to 1 where they are above, the RMS difference of the radiosity from that
// of exact exchange areas, as a share of it, over all surfaces but the lamp.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <fstream>

#include "app/context/context.h"
#include "techniques/radiosity/exchange/hemicube_exchange.h"
#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "techniques/radiosity/form_factors/polygon_exchange.h"
#include "tests/radiosity/scene_room.h"
#include "tests/speed/log_log_plot.h"
#include "tests/speed/radiosity_bench.h"

namespace shadowlab::radiosity {

namespace {

constexpr int kRounds = 3;
constexpr int kSides[] = {16, 32, 64, 128, 256, 512};

struct Error {
    double largest = 0, squares = 0;
    std::size_t count = 0;
    void add(double wrong) {
        largest = std::max(largest, std::abs(wrong));
        squares += wrong * wrong;
        ++count;
    }
    [[nodiscard]] double rms() const { return std::sqrt(squares / static_cast<double>(count)); }
};

struct Row {
    Error pixels, inAll;
    std::vector<double> ms;
    ReciprocityGap gap;
    double ofRadiosity = 0;
};

/// Over all pairs of patches that see each other.
void errorsInCube(const testing::Room& cube, int side, Row& row) {
    Hemicube hemicube(side);
    hemicube.setPatches(cube.patches);
    for (const Patch& from : cube.patches) {
        const std::vector<double> factors = hemicube.formFactors(from);
        for (std::size_t j = 0; j < cube.patches.size(); ++j) {
            const Patch& to = cube.patches[j];
            if (to.face == from.face) continue;
            row.pixels.add(factors[j] - pointFormFactor(from.centre, from.normal, to.polygon));
            row.inAll.add(factors[j] - unoccludedExchange(from.polygon, to.polygon).area / from.area);
        }
    }
}

double difference(const CornellRoom& room, const std::vector<dvec3>& radiosity, const std::vector<dvec3>& exact) {
    double wrong = 0, all = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (room.isLamp(i)) continue;
        const dvec3 d = radiosity[i] - exact[i];
        wrong += room.patches[i].area * glm::dot(d, d);
        all += room.patches[i].area * glm::dot(exact[i], exact[i]);
    }
    return std::sqrt(wrong / all);
}

void draw(const std::vector<Row>& rows, const std::filesystem::path& file) {
    LogLogPlot plot{.xLabel = "pixels along the upper face of the hemicube",
                    .yLabel = "error of a form factor",
                    .firstX = 14,
                    .lastX = 600,
                    .xMarks = {},
                    .firstPower = -5,
                    .lastPower = -1,
                    .lines = {{"largest", "#d55e00", {}, {}},
                              {"root mean square", "#0072b2", {}, {}},
                              {"", "#d55e00", {}, {}, true},
                              {"", "#0072b2", {}, {}, true}},
                    .remark = "dashed: pixels alone"};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        plot.xMarks.push_back(kSides[i]);
        const double values[] = {rows[i].inAll.largest, rows[i].inAll.rms(), rows[i].pixels.largest,
                                 rows[i].pixels.rms()};
        for (std::size_t line = 0; line < 4; ++line) {
            plot.lines[line].x.push_back(kSides[i]);
            plot.lines[line].y.push_back(values[line]);
        }
    }
    std::ofstream(file) << logLogPlot(plot);
}

} // namespace

void benchHemicube(std::size_t count, const std::filesystem::path& plots) {
    const auto context = context::createContext(context::Backend::automatic);
    std::vector<Row> rows(std::size(kSides));
    const testing::Room cube(testing::emptyRoom({1, 1, 1}), 0.125);
    const CornellRoom room(count);
    std::vector<double> exactMs;
    std::vector<dvec3> exact;
    for (int round = 0; round < kRounds; ++round) {
        std::optional<ExchangeMatrix> exchange;
        exactMs.push_back(clockMs([&] { exchange = exactExchange(room); }));
        if (round == 0) exact = solved(room.problem(*exchange));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            HemicubeExchange hemicubes(room.patches, kSides[i]);
            rows[i].ms.push_back(clockMs([&] { hemicubes.advance(std::chrono::steady_clock::time_point::max()); }));
            rows[i].gap = hemicubes.gap();
            if (round > 0) continue;
            const ScaledExchange scaled = scaledToClosure(hemicubes.take(), room.areas(), Closure::openScene);
            rows[i].ofRadiosity = difference(room, solved(room.problem(scaled.exchange)), exact);
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        errorsInCube(cube, kSides[i], rows[i]);

    std::printf("%s; a cube of %zu patches; cornell-room, %zu patches\n", context::glRenderer().c_str(),
                cube.patches.size(), room.patches.size());
    std::printf("| %4s | %-19s | %-19s | %8s | %-17s | %10s |\n", "side", "pixels: max, RMS", "in all: max, RMS", "s",
                "gap: max, share", "radiosity");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        std::printf("| %4d | %9.2e %9.2e | %9.2e %9.2e | %8.2f | %8.2e %8.5f | %10.5f |\n", kSides[i],
                    row.pixels.largest, row.pixels.rms(), row.inAll.largest, row.inAll.rms(), median(row.ms) / 1000,
                    row.gap.largest, row.gap.share, row.ofRadiosity);
    }
    std::printf("exact exchange areas: %.2f s\n", median(exactMs) / 1000);
    const Polygon floor{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, wall{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
    const double whole = unoccludedExchange(floor, wall).area;
    const double centre = pointFormFactor({0.5, 0, 0.5}, {0, 1, 0}, wall);
    std::printf("two squares that share an edge: %.6f from the centre, %.6f from all of it: %+.2f %%\n", centre, whole,
                100 * (centre / whole - 1));
    if (!plots.empty()) draw(rows, plots / "radiosity-hemicube.svg");
}

} // namespace shadowlab::radiosity
