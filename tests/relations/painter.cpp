// SPDX-License-Identifier: MIT
#include "tests/relations/painter.h"

#include <algorithm>

#include "app/judge/slot_errors.h"
#include "app/lab/settings.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "tests/support/scenes.h"

namespace shadowlab::relations {

namespace {

bool hasParam(const picture::Slot& slot, std::string_view id) {
    return std::ranges::any_of(slot.params, [&](const params::Param& param) { return param.id == id; });
}

/// A room of hundreds of patches is solved in seconds; relations hold for a coarser one just as well. But patches have a lamp with an area in the mean
/// alone and one without at each point, and with 60 of them, in which a lamp becomes a tiny ball, what is reflected differs by three levels of 255.
std::vector<std::string> thrifty(const picture::Slot& slot) {
    std::vector<std::string> settings;
    for (const auto& [param, value] : {std::pair("patches", "120"), std::pair("light-map-points", "2000")})
        if (hasParam(slot, param)) settings.push_back(std::string(param) + "=" + value);
    return settings;
}

/// A box above a ball above a floor: the ball's upper half is in shadow, and whoever does not serve what is curved, or
/// draws no shadows at all, is wrong in hundreds of pixels.
scene::Scene control() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeSphere(0.75, 32), testing::translation({0, 1, 0}));
    testing::addObject(scene, scene::makeBox({2, 0.25, 2}), testing::translation({0.25, 2.5, 0}));
    scene.lights = {testing::pointLight({0.5, 6, 1}), testing::directionalLight({0.25, -1, -0.125})};
    return scene;
}

/// A box in the ball's place.
scene::Scene controlOfFlatFaces() {
    scene::Scene scene = control();
    scene.objects[1].mesh = scene::sharedMesh(scene::makeBox({1, 1, 1}));
    return scene;
}

/// The eye in the shadow of the upper box.
scene::Scene controlFromShadow() {
    scene::Scene scene = control();
    scene.camera.positionWorld = {0.75, 2.1, 0.5};
    return scene;
}

} // namespace

Picture rearranged(const Picture& picture, ivec2 size, const std::function<ivec2(ivec2)>& from) {
    Picture result;
    result.size = size;
    result.smoothPx = picture.smoothPx;
    result.shown = image::Image(size.x, size.y);
    const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    result.radiance.resize(pixels);
    result.texelPx.resize(picture.texelPx.empty() ? 0 : pixels);
    result.visibility.assign(picture.visibility.size(), {size.x, size.y, std::vector<std::uint8_t>(2 * pixels)});
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const ivec2 source = from({x, y});
            const std::size_t to = result.index(x, y), old = picture.index(source.x, source.y);
            result.shown.set(x, y, picture.shown.at(source.x, source.y));
            result.radiance[to] = picture.radiance[old];
            if (!result.texelPx.empty()) result.texelPx[to] = picture.texelPx[old];
            for (std::size_t light = 0; light < picture.visibility.size(); ++light)
                for (std::size_t channel = 0; channel < 2; ++channel)
                    result.visibility[light].greyAlpha[2 * to + channel] =
                        picture.visibility[light].greyAlpha[2 * old + channel];
        }
    return result;
}

Painter::Painter(std::string technique, std::vector<std::string> settings, Fault fault)
    : technique_(std::move(technique)), fault_(std::move(fault)), slot_(picture::Session::makeSlot(technique_)) {
    std::vector<picture::Slot> slots;
    slots.push_back(std::move(slot_));
    std::vector<std::string> full;
    for (const auto& list : {thrifty(slots[0]), settings})
        for (const std::string& setting : list)
            full.push_back(technique_ + "." + setting);
    lab::applySettings(slots, full);
    slot_ = std::move(slots[0]);
}

Picture Painter::paint(scene::Scene scene, ivec2 size, const Region& region) {
    scene.revisions = {}; // whoever made it changed a copy
    painted_.push_back(scene);
    if (fault_) fault_(scene);
    const scene::Snapshot snapshot = testing::snapshot(std::move(scene));
    picture::Session session(snapshot);
    View view;
    view.camera = snapshot->camera;
    view.size = size;
    view.region = region;
    FrameRequest request;
    const bool hasTexels = publishes(*slot_.info, "texel-size");
    const int lights = static_cast<int>(snapshot->lights.size());
    for (int light = 0; light < lights; ++light) {
        request.stages.push_back({"visibility", light});
        if (hasTexels) request.stages.push_back({"texel-size", light});
    }
    const picture::RenderedFrame frame = session.render(slot_, view, request);
    Picture picture;
    picture.size = size;
    picture.shown = encoder_.encode(slot_.target.color, snapshot->exposure);
    picture.radiance = gl::readTexels(slot_.target.color);
    if (hasTexels) picture.texelPx.resize(picture.radiance.size());
    // Two thousand points on two hundred square metres, both sides of things, are a third of a metre apart: here up to twelve pixels.
    if (hasParam(slot_, "patches")) picture.smoothPx = 12;
    for (int light = 0; light < lights; ++light) {
        picture.visibility.push_back(picture::readVisibility(picture::findStage(frame, {"visibility", light})));
        if (!hasTexels) continue;
        const judge::Grid<float> sizes = picture::readTexelSizes(picture::findStage(frame, {"texel-size", light}));
        for (std::size_t i = 0; i < sizes.values.size(); ++i)
            picture.texelPx[i] = std::max(picture.texelPx[i], sizes.values[i]);
    }
    return picture;
}

const Traits& Painter::traits() {
    if (!traits_) traits_ = findTraits();
    return *traits_;
}

bool Painter::isRight(const scene::Scene& scene) {
    const Picture picture = paint(scene);
    painted_.pop_back();
    picture::Session session(testing::snapshot(scene));
    View view;
    view.camera = scene.camera;
    view.size = picture.size;
    int wrong = 0, pixels = 0;
    for (int light = 0; light < static_cast<int>(picture.visibility.size()); ++light) {
        const judge::Truth& truth = session.truth(view, light);
        const auto judged = judge::judge(truth, picture.visibility[static_cast<std::size_t>(light)].greyAlpha);
        wrong += judged.counts.wrong();
        pixels += judged.counts.pixels;
    }
    // Half a percent: a map's edges are wrong by less, and a ball that is lit instead of dark is more.
    constexpr double kShareAtEdges = 0.005;
    return wrong <= kShareAtEdges * pixels;
}

Traits Painter::findTraits() {
    return {.solvesRoom = hasParam(slot_, "patches"),
            .hasTexels = publishes(*slot_.info, "texel-size"),
            .servesAll = isRight(control()),
            .servesFlat = isRight(controlOfFlatFaces()),
            .seesFromShadow = isRight(controlFromShadow())};
}

std::vector<std::string> registeredIds() {
    std::vector<std::string> ids;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production))
        ids.emplace_back(technique.info->id);
    return ids;
}

} // namespace shadowlab::relations
