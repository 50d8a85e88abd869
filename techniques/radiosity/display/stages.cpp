// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/stages.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/base/look.h"
#include "techniques/radiosity/probe.h"

namespace shadowlab::radiosity {

namespace {

void publishRadiance(const Showing& showing, std::string_view stage, const std::function<void()>& draw) {
    if (showing.frame.wants(stage))
        showing.frame.drawStage(stage, kNoLight, GL_RGBA16F, [&] {
            const vec3& background = showing.frame.scene().background;
            glClearColor(background.r, background.g, background.b, 1);
            glClear(GL_COLOR_BUFFER_BIT);
            draw();
        });
}
void publishRadiance(const Showing& showing, std::string_view stage, std::span<const dvec3> radiosity,
                     bool interpolates) {
    publishRadiance(showing, stage, [&] { showing.draw(radiosity, interpolates); });
}

void publishScalar(const Showing& showing, std::string_view stage, const std::vector<dvec3>& values,
                   const Display& display) {
    showing.frame.drawStage(
        stage, kNoLight, GL_RG32F,
        [&] {
            const auto uploaded = SurfacePicture::upload(cellValues(showing.cache.cells(), values));
            showing.picture.drawScalar(showing.frame, uploaded, false);
        },
        display);
}

/// One value for each patch that exchanges light; loose patches get `ofLoose`.
std::vector<dvec3> asValues(const Showing& showing, std::span<const double> numbers, double ofLoose) {
    std::vector<dvec3> values;
    for (const double number : numbers)
        values.emplace_back(number);
    values.resize(showing.sources.size(), dvec3(ofLoose));
    return values;
}

void publishPatches(const Showing& showing) {
    // A lighter step of viridis for each further cut.
    static const std::vector<KeyEntry> key = {{look::linearFromSrgb8(0xB8, 0xB8, 0xB4), "patch, cut to size"},
                                              {look::colorAt(look::viridis(), 0.3), "cut again once"},
                                              {look::colorAt(look::viridis(), 0.5), "twice"},
                                              {look::colorAt(look::viridis(), 0.7), "three times"},
                                              {look::colorAt(look::viridis(), 0.95), "more often"},
                                              {look::kNoSurface, "border of a patch"}};
    const bool isRefined = showing.cache.isRefined();
    std::vector<dvec3> colors(showing.sources.size(), dvec3(key[0].colorLinear));
    for (std::size_t i = 0; i < showing.cache.room().levels().size(); ++i)
        colors[i] = dvec3(key[std::min<std::size_t>(showing.cache.room().levels()[i], 4)].colorLinear);
    showing.frame.drawStage("patches", kNoLight, GL_RGBA16F,
                            [&] {
                                const auto uploaded = SurfacePicture::upload(cellValues(showing.cache.cells(), colors));
                                showing.picture.drawOutlines(showing.frame, uploaded, key.back().colorLinear);
                            },
                            {.unit = "", .key = isRefined ? key : std::vector<KeyEntry>{key.front(), key.back()}});
}

/// The patch whose form factors are shown: the picked pixel's, that of parameter `from-patch`, or the one that sends the most
/// light.
std::size_t chosenPatch(const Showing& showing) {
    const std::size_t count = showing.cache.room().patches().size();
    const View& view = showing.frame.view();
    if (view.picked)
        if (const auto seen = patchSeen(showing.cache, showing.frame.snapshot(), view, *view.picked)) return *seen;
    if (showing.params.fromPatch >= 0 && static_cast<std::size_t>(showing.params.fromPatch) < count)
        return static_cast<std::size_t>(showing.params.fromPatch);
    std::size_t best = 0;
    double most = -1;
    for (std::size_t i = 0; i < count; ++i) {
        const double power = luminance(showing.balance.radiosity()[i]) * showing.cache.exchange().areas[i];
        if (power > most) {
            most = power;
            best = i;
        }
    }
    return best;
}

void publishFormFactors(const Showing& showing) {
    const std::size_t count = showing.cache.room().patches().size();
    std::vector<double> shares(count, 0.0);
    double most = 0;
    if (const std::size_t from = count > 0 ? chosenPatch(showing) : 0; from < count) { // loose patches see nothing
        for (std::size_t j = 0; j < count; ++j)
            shares[j] = 100 * showing.cache.exchange().matrix(from, j) / showing.cache.exchange().areas[from];
        most = *std::ranges::max_element(shares);
    }
    publishScalar(showing, "form-factors", asValues(showing, shares, 0),
                  {.minimum = 0, .maximum = most > 0 ? most : 1, .unit = "% of its light", .key = {}});
}

void publishResidual(const Showing& showing) {
    std::vector<dvec3> values = showing.balance.residual();
    double most = 0;
    for (dvec3& value : values) {
        value = dvec3(std::abs(luminance(value)));
        most = std::max(most, value.x);
    }
    publishScalar(showing, "residual", values,
                  {.minimum = 0, .maximum = most > 0 ? most : 1, .unit = "W/m^2", .key = {}});
}

void publishVisibility(const Showing& showing, int light, const DirectShown& direct) {
    const SurfaceCells& cells = showing.cache.cells();
    if (direct.pixels) {
        showing.frame.drawStage("visibility", light, GL_RG32F, [&] { direct.pixels->drawVisibility(showing.frame, light); });
        return;
    }
    if (const LightMap* const map = direct.map) {
        const LightMap::Values seen = map->seenArea(cells, light);
        const std::vector<dvec3> nothing(showing.sources.size(), dvec3(0)); // the map holds all of it
        const auto uploaded = SurfacePicture::upload(cellValues(cells, nothing, seen.atBlends));
        const auto lattices = SurfacePicture::upload(map->lattices(), seen.atPoints);
        showing.frame.drawStage("visibility", light, GL_RG32F,
                                [&] { showing.picture.drawVisibility(showing.frame, uploaded, lattices, light); });
        return;
    }
    std::vector<dvec3> shares;
    for (const double share : showing.cache.light(light).seenArea)
        shares.emplace_back(share);
    const auto uploaded = SurfacePicture::upload(cellValues(cells, shares));
    const bool interpolates = showing.params.display != RadiosityParams::Display::flat;
    showing.frame.drawStage("visibility", light, GL_RG32F,
                            [&] { showing.picture.drawVisibility(showing.frame, uploaded, interpolates, light); });
}

} // namespace

void Showing::draw(std::span<const dvec3> radiosity, bool interpolates) const {
    picture.drawRadiosity(frame, SurfacePicture::upload(cellValues(cache.cells(), radiosity)), interpolates,
                          params.exposureFactor());
}

void Showing::drawSmooth(const ShownLight& shown) const {
    picture.drawReflected(frame, shown.values, shown.map ? &*shown.map : nullptr, params.exposureFactor());
}

ShownLight Showing::shown(const DirectShown& direct) const {
    std::vector<dvec3> arriving = balance.irradianceShown();
    // Light from other patches and from the surroundings changes slowly and is interpolated, whatever direct light is.
    if (direct.pixels || direct.map)
        for (std::size_t i = 0; i < arriving.size(); ++i)
            arriving[i] -= sources.fromLights[i];
    if (!direct.map) return {SurfacePicture::upload(cellValues(cache.cells(), arriving)), std::nullopt};
    const LightMap::Values found = direct.map->irradiance(cache.cells());
    std::vector<dvec3> atBlends = blended(cache.cells(), arriving);
    for (std::size_t i = 0; i < atBlends.size(); ++i)
        atBlends[i] += found.atBlends[i];
    return {SurfacePicture::upload(cellValues(cache.cells(), arriving, atBlends)),
            SurfacePicture::upload(direct.map->lattices(), found.atPoints)};
}

void publishStages(const Showing& showing, const DirectShown& direct) {
    const Frame& frame = showing.frame;
    if (frame.wants("patches")) publishPatches(showing);
    if (frame.wants("form-factors")) publishFormFactors(showing);
    if (frame.wants("matrix")) publishMatrix(showing.frame, showing.cache.exchange());
    if (frame.wants("row-sums")) {
        const std::vector<double>& sums = showing.cache.exchange().rowSums;
        const double most = sums.empty() ? 1 : std::max(1.0, *std::ranges::max_element(sums));
        publishScalar(showing, "row-sums", asValues(showing, sums, 0),
                      {.minimum = 0, .maximum = most, .unit = "sum of form factors", .key = {}});
    }
    if (frame.wants("surroundings"))
        publishScalar(showing, "surroundings", asValues(showing, showing.cache.room().surroundings(), 1),
                      {.minimum = 0, .maximum = 1, .unit = "share of its view", .key = {}});
    publishRadiance(showing, "emission", showing.sources.emission, false);
    if (frame.wants("first-bounce")) publishRadiance(showing, "first-bounce", showing.balance.bounce(1), false);
    if (frame.wants("bounce"))
        publishRadiance(showing, "bounce", showing.balance.bounce(static_cast<std::size_t>(showing.params.bounce)),
                        false);
    if (frame.wants("reflected")) {
        std::vector<dvec3> more = showing.balance.radiosity();
        const std::vector<dvec3> once = showing.balance.bounce(1);
        for (std::size_t i = 0; i < more.size(); ++i)
            more[i] = glm::max(more[i] - once[i] - showing.sources.emission[i], dvec3(0));
        publishRadiance(showing, "reflected", more, true);
    }
    if (frame.wants("residual")) publishResidual(showing);
    publishRadiance(showing, "radiosity", showing.balance.radiosity(), false);
    publishRadiance(showing, "interpolated", [&] { showing.drawSmooth(showing.shown({})); });
    for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light)
        if (frame.wants("visibility", light)) publishVisibility(showing, light, direct);
}

} // namespace shadowlab::radiosity
