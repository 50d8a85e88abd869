// Radiosity in the order of the lecture's pages: the form factor, its properties, patches, the radiosity equations.
//
// C. M. Goral, K. E. Torrance, D. P. Greenberg and B. Battaile, "Modeling the Interaction of Light Between Diffuse Surfaces",
// SIGGRAPH 1984. Every surface has two sides, front and back, and each is a patch of its own: i = 2 * patch, or 2 * patch + 1.
// Simplified: integrals are sums over up to four points of each patch; of two patches up to four lines say how much stands between
// them; meshes finer than patches are joined to patches that are not flat; a patch has one colour; lights are points in their middle.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/frame.h"
#include "techniques/lecture/lecture.h"
#include "techniques/lecture/parts/patch_picture.h"
#include "techniques/lecture/words/radiosity.h"

namespace shadowlab::lecture {

namespace {

// --- Form Factor -----------------------------------------------------------------------------------------------------

// The lecture's integrand, times both areas. For pieces that touch, 1 / r^2 grows beyond all bounds; no piece exchanges more than its area.
// [anchor: lecture-exchange]
double exchange(const SurfacePoint& j, const SurfacePoint& k) {
    const dvec3 way = k.positionWorld - j.positionWorld;
    const double r = glm::length(way);
    if (r == 0) return 0; // one surface lies on the other
    const double cosJ = std::abs(glm::dot(j.N, way)) / r, cosK = std::abs(glm::dot(k.N, way)) / r;
    return std::min({cosJ * cosK / (glm::pi<double>() * r * r) * j.area * k.area, j.area, k.area});
}

} // namespace

// F_jk = V / A_j * sum over both patches of cos phi_j cos phi_k / (pi r^2) dA_j dA_k, V being the share of lines between them that
// are free; and its first property, A_j F_jk = A_k F_kj.
// [anchor: lecture-form-factors]
void addFormFactors(const RayScene& rays, const std::vector<Patch>& patches, std::size_t j, FormFactors& F) {
    for (std::size_t k = j + 1; k < patches.size(); ++k) {
        const std::vector<SurfacePoint>&pointsJ = patches[j].points, &pointsK = patches[k].points;
        std::array<double, 4> exchanged{}; // by the front or back of j and the front or back of k
        for (const SurfacePoint& p : pointsJ)
            for (const SurfacePoint& q : pointsK) {
                const bool backOfJ = glm::dot(p.N, q.positionWorld - p.positionWorld) < 0;
                const bool backOfK = glm::dot(q.N, p.positionWorld - q.positionWorld) < 0;
                exchanged[2 * backOfJ + backOfK] += exchange(p, q);
            }
        if (exchanged == std::array<double, 4>{}) continue; // in one plane
        const std::size_t lines = std::max(pointsJ.size(), pointsK.size());
        double free = 0;
        for (std::size_t line = 0; line < lines; ++line) {
            const SurfacePoint &p = pointsJ[line % pointsJ.size()], &q = pointsK[line % pointsK.size()];
            free += rays.isFree(*p.triangle, p.positionWorld, q.positionWorld);
        }
        for (std::size_t sides = 0; sides < 4; ++sides) {
            const std::size_t sideJ = 2 * j + sides / 2, sideK = 2 * k + sides % 2;
            const double visible = free / static_cast<double>(lines) * exchanged[sides];
            F.at(sideJ, sideK) = static_cast<float>(visible / patches[j].area);
            F.at(sideK, sideJ) = static_cast<float>(visible / patches[k].area);
        }
    }
}

namespace {

// The second property: in an enclosed space the sum over k of F_jk is 1. A sum above 1, an error of integrals taken as sums, would create
// light: the row is divided by it. Below 1, the rest of the directions meets no surface. Returns the sum before the division.
double limitRow(FormFactors& F, std::size_t j) {
    double sum = 0;
    for (std::size_t k = 0; k < F.n; ++k)
        sum += F.at(j, k);
    for (std::size_t k = 0; sum > 1 && k < F.n; ++k)
        F.at(j, k) /= static_cast<float>(sum);
    return sum;
}

// --- Basic Radiosity Model -------------------------------------------------------------------------------------------

/// What a light that is no patch brings to one side of a patch: W/m^2, and the share of the points facing it that see it.
struct Arriving {
    dvec3 irradiance{0.0};
    double seen = 0;
};

Arriving arriving(const RayScene& rays, const Patch& patch, bool onBack, int light) {
    constexpr double kFar = 1e9; // metres: toward the sun, beyond any scene
    const scene::Light& source = rays.scene().light(light);
    const bool isSun = source.type == scene::LightType::directional;
    Arriving sum;
    double facing = 0;
    for (const SurfacePoint& point : patch.points) {
        const int lightSide = rays.lightSide(*point.triangle, light);
        if ((onBack ? -lightSide : lightSide) <= 0) continue;
        facing += 1;
        const dvec3& place = point.positionWorld;
        const dvec3 lightWorld = isSun ? place - kFar * source.directionWorld : source.positionWorld;
        const bool receives = rays.objectOf(*point.triangle).receivesShadow;
        if (receives && !rays.isFree(*point.triangle, place, lightWorld)) continue;
        sum.seen += 1;
        if (scene::lightShinesTo(source, place))
            sum.irradiance += point.area / patch.area * scene::irradiance(source, place, onBack ? -point.N : point.N);
    }
    sum.seen = facing > 0 ? sum.seen / facing : 1; // no point of a curved patch faces it: nothing is known to hide it
    return sum;
}

/// "B_i radiosity of surface i, E_i energy emission rate per unit area of surface i, rho_i reflectivity of surface i."
struct Equations {
    std::vector<dvec3> B, E, rho; ///< W/m^2, W/m^2, 0..1; B is empty until they are solved
    FormFactors F;
};

// "The object surfaces must form an enclosed space": where a patch sees no surface, a wall in the colour of the background is taken to
// be. Lights of the scene are no patches; what a patch reflects of their light counts as emitted.
// [anchor: lecture-emission]
dvec3 emission(const dvec3& emitted, const dvec3& rho, const dvec3& irradianceByLights, double rowSum, const dvec3& background) {
    const double pi = glm::pi<double>(); // of a Lambertian emitter B = pi * intensity
    return pi * emitted +
           rho * (irradianceByLights + (1 - rowSum) * pi * background);
}

// "Solve radiosity equations" B_i - rho_i * sum over k of F_ik B_k = E_i: each patch gathers what all others send it, from the
// radiosities before. Begun with B = E, every repetition adds the light of one more reflection (C. Jacobi's iteration, 1845).
// [anchor: lecture-gather]
void gather(Equations& equations) {
    const std::vector<dvec3> before = equations.B;
    trace::parallelFor(equations.B.size(), [&](std::size_t i) {
        dvec3 gathered(0.0);
        for (std::size_t k = 0; k < before.size(); ++k)
            gathered += static_cast<double>(equations.F.at(i, k)) * before[k];
        equations.B[i] = equations.E[i] + equations.rho[i] * gathered;
    });
}

// --- Passes ----------------------------------------------------------------------------------------------------------

class Radiosity final : public Technique {
public:
    params::ParamList params() override {
        return {params::integer({"patches", "Number of patches"}, patches_, 50, 2000, "patches",
                                "At most so many, of two sides each; time and memory grow with the square."),
                params::integer("bounces", bounces_, 0, 1000, "", "How often each patch gathers from all others.")};
    }

    Progress prepare(const scene::Snapshot& snapshot, Deadline deadline) override {
        const Asked asked{snapshot, patches_, bounces_};
        if (asked != asked_) {
            asked_ = {};
            rays_ = RayScene(snapshot);
            surfaces_ = divideSurfaces(rays_, static_cast<std::size_t>(patches_));
            const std::size_t n = 2 * surfaces_.patches.size();
            equations_ = {{}, std::vector<dvec3>(n), std::vector<dvec3>(n), {n, std::vector<float>(n * n)}};
            rowsDone_ = 0;
            asked_ = asked;
        }
        const std::size_t count = surfaces_.patches.size();
        rowsDone_ = trace::parallelUntil(deadline, rowsDone_, count, [&](std::size_t j) {
            addFormFactors(rays_, surfaces_.patches, j, equations_.F);
        });
        if (rowsDone_ < count) return {static_cast<double>(rowsDone_) / static_cast<double>(count), false};
        if (equations_.B.empty()) solve();
        return {};
    }

    Progress render(Frame& frame) override {
        frame.pass(passInfo(kRadiosityPasses, "patches"), [&] { picture_.begin(frame, rays_, surfaces_); });
        frame.pass(passInfo(kRadiosityPasses, "form-factors"), [&] {});
        frame.pass(passInfo(kRadiosityPasses, "emission"), [&] { picture_.drawRadiosity(frame, equations_.E); });
        frame.pass(passInfo(kRadiosityPasses, "gather"), [&] { picture_.drawRadiosity(frame, equations_.B); });
        publishStages(frame);
        return {};
    }

private:
    void solve() {
        const scene::Scene& scene = rays_.scene();
        rowSums_.clear();
        seen_.assign(scene.lights.size(), {});
        for (std::size_t i = 0; i < equations_.E.size(); ++i) {
            const Patch& patch = surfaces_.patches[i / 2];
            dvec3 irradiance(0.0);
            for (std::size_t light = 0; light < scene.lights.size(); ++light) {
                const Arriving ofLight = arriving(rays_, patch, i % 2 == 1, static_cast<int>(light));
                irradiance += ofLight.irradiance;
                seen_[light].emplace_back(ofLight.seen, 1, 0);
            }
            rowSums_.emplace_back(limitRow(equations_.F, i), 1, 0);
            equations_.rho[i] = patch.diffuse;
            const double rowSum = std::min(1.0, rowSums_[i].x);
            equations_.E[i] = emission(emittedBySide(patch, i), equations_.rho[i], irradiance, rowSum, dvec3(scene.background));
        }
        equations_.B = equations_.E;
        for (int bounce = 0; bounce < bounces_; ++bounce)
            gather(equations_);
    }

    void publishStages(Frame& frame) const {
        const auto brightest = std::ranges::max_element(equations_.B, {}, &dvec3::g) - equations_.B.begin();
        std::vector<dvec3> shares;
        for (std::size_t k = 0; k < equations_.F.n; ++k)
            shares.emplace_back(100 * equations_.F.at(static_cast<std::size_t>(brightest), k), 1, 0);
        picture_.publishPatches(frame);
        picture_.publishNumbers(frame, "form-factors", shares, 0.1, "% of its light");
        picture_.publishNumbers(frame, "row-sums", rowSums_, 1.25, "sum of form factors");
        for (std::size_t light = 0; light < seen_.size(); ++light)
            picture_.publishVisibility(frame, static_cast<int>(light), seen_[light]);
    }

    using Asked = std::tuple<scene::Snapshot, int, int>;
    int patches_ = 1200; // form factors take about a second
    int bounces_ = 20;   // where 0.8 is reflected each time, 1 % of the light is left
    Asked asked_;
    RayScene rays_;
    DividedSurfaces surfaces_;
    Equations equations_;
    std::vector<dvec3> rowSums_;           ///< (sum, 1, 0) of each side
    std::vector<std::vector<dvec3>> seen_; ///< the same for each light: the share of it that is seen
    std::size_t rowsDone_ = 0;             ///< of form factors, by patches
    PatchPicture picture_;
};

} // namespace

const TechniqueInfo& radiosity() {
    using enum scene::LightType;
    static const TechniqueInfo info{
        .id = "lecture-radiosity",
        .title = "Lecture: radiosity",
        .paper =
            "Goral, Torrance, Greenberg and Battaile 1984, Modeling the Interaction of Light Between Diffuse Surfaces",
        .getsWrong = "shadows are as coarse as patches; mirrors, glass and highlights are dull",
        .order = 160,
        .group = TechniqueGroup::lecture,
        .sister = "radiosity",
        .lightTypes = {point, directional, spot, rect, sphere},
        .passes = {std::begin(kRadiosityPasses), std::end(kRadiosityPasses)},
        .stages = {std::begin(kRadiosityStages), std::end(kRadiosityStages)},
        .pseudocode = kBasicRadiosityModel,
        .make = []() -> std::unique_ptr<Technique> { return std::make_unique<Radiosity>(); },
    };
    return info;
}

} // namespace shadowlab::lecture
