// SPDX-License-Identifier: MIT
#include "app/window/object_places.h"

#include <algorithm>

#include "app/lab/object_picking.h"
#include "app/window/picture_view.h"
#include "app/window/widget_renderer.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::window {

namespace {

constexpr float kFillsPane = 0.3f;         ///< of its area: there is no place beside a backdrop that is larger
constexpr std::size_t kMostVertices = 512; ///< looked at of each object
constexpr float kStripEm = 0.75f;          ///< height of the boxes that cover an object
constexpr float kRimEm = 0.2f;             ///< around it, which some of its vertices show too small
constexpr float kSignEm = 1.1f;            ///< of a light or the eye, seen from outside

float cross(ImVec2 a, ImVec2 b, ImVec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Andrew's monotone chain: the corners in their order around.
std::vector<ImVec2> convexHull(std::vector<ImVec2> points) {
    std::ranges::sort(points, [](ImVec2 a, ImVec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    if (points.size() < 3) return points;
    std::vector<ImVec2> hull;
    const auto addChain = [&](auto first, auto last) {
        const std::size_t begin = hull.size();
        for (auto point = first; point != last; ++point) {
            while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), *point) <= 0)
                hull.pop_back();
            hull.push_back(*point);
        }
        hull.pop_back(); // the other chain begins with it
    };
    addChain(points.begin(), points.end());
    addChain(points.rbegin(), points.rend());
    return hull;
}

/// The part of a hull between two heights, as a box; nothing where it has none.
std::optional<PlaceBox> strip(const std::vector<ImVec2>& hull, float top, float bottom) {
    float least = FLT_MAX, most = -FLT_MAX;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const ImVec2 from = hull[i], to = hull[(i + 1) % hull.size()];
        const float low = std::max(top, std::min(from.y, to.y)), high = std::min(bottom, std::max(from.y, to.y));
        if (low > high) continue;
        for (const float y : {low, high}) {
            const float share = to.y == from.y ? 0 : (y - from.y) / (to.y - from.y);
            const float x = from.x + share * (to.x - from.x);
            least = std::min({least, x, to.y == from.y ? to.x : x});
            most = std::max({most, x, to.y == from.y ? to.x : x});
        }
    }
    if (least > most) return {};
    return PlaceBox{{least, top}, {most, bottom}};
}

/// Around the object in the picture, by some of its vertices.
std::vector<ImVec2> seenHull(const PictureView& view, const scene::Object& object) {
    const std::vector<vec3>& vertices = object.mesh->positionsMesh;
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    std::vector<ImVec2> seen;
    for (std::size_t i = 0; i < vertices.size(); i += vertices.size() / kMostVertices + 1)
        if (const auto at = view.place(transformPoint(worldFromMesh, dvec3(vertices[i])))) seen.push_back(*at);
    return convexHull(std::move(seen));
}

/// Is it what the others stand on, or in?
bool isGround(const std::vector<scene::Bounds>& bounds, std::size_t object) {
    const scene::Bounds& box = bounds[object];
    const auto standsOnIt = [&](const scene::Bounds& other) {
        if (other.isEmpty()) return false;
        const dvec3 foot = 0.5 * (other.corner(0) + other.corner(5)); // y is up
        return foot.x > box.lowerWorld.x && foot.x < box.upperWorld.x && foot.z > box.lowerWorld.z && foot.z < box.upperWorld.z &&
               foot.y > 0.5 * (box.lowerWorld.y + box.upperWorld.y);
    };
    return lab::isBackdrop(bounds, object) || std::ranges::any_of(bounds, standsOnIt);
}

/// In boxes below one another, as far as they lie in the pane.
std::vector<PlaceBox> boxesOf(const std::vector<ImVec2>& hull, const PlaceBox& pane, float height, float rim) {
    float top = FLT_MAX, bottom = -FLT_MAX;
    for (const ImVec2 at : hull) {
        top = std::min(top, at.y);
        bottom = std::max(bottom, at.y);
    }
    std::vector<PlaceBox> boxes;
    bottom = std::min(bottom, pane.high.y);
    for (float y = std::max(top, pane.low.y); y < bottom; y += height)
        if (const auto box = strip(hull, y, std::min(y + height, bottom)); box && overlap(*box, pane) > 0)
            boxes.push_back({{std::max(box->low.x - rim, pane.low.x), box->low.y - rim},
                             {std::min(box->high.x + rim, pane.high.x), box->high.y + rim}});
    return boxes;
}

/// The labels are a part of the picture, and so have its pixels.
void takeOutsideSigns(FreePlaces& places, const WindowState& ui, const lab::Pane& pane, const PictureView& view, const Theme& theme) {
    const float scale = view.picture().size().x / static_cast<float>(std::max(1, pane.picture().texture.size().x));
    for (const picture::PlacedLabel& label : pane.outsideLabels()) {
        const auto at = [&](const dvec2& pixel) {
            const ImVec2 low = view.picture().low;
            return ImVec2(low.x + scale * static_cast<float>(pixel.x), low.y + scale * static_cast<float>(pixel.y));
        };
        places.take({at(label.box.lower), at(label.box.upper)}, FreePlaces::kSign);
    }
    const auto takeSign = [&](const dvec3& positionWorld) {
        if (const auto at = view.place(positionWorld)) places.take(PlaceBox::around(*at, kSignEm * theme.em), FreePlaces::kSign);
    };
    takeSign(pane.drawnFor().view.camera.positionWorld);
    for (const scene::Light& light : ui.bench.shownScene()->lights)
        if (light.type != scene::LightType::directional) takeSign(light.positionWorld);
}

} // namespace

FreePlaces placesBesideThings(WindowState& ui, const ShownPane& shown, const Theme& theme) {
    FreePlaces places(shown.area);
    const lab::Pane& pane = ui.bench.pane(shown.pane);
    const auto view = pictureView(ui, shown);
    const PlaceBox area{imVec(shown.area.corner), imVec(shown.area.corner + shown.area.size)};
    if (!view) { // a light's view of the scene, which is all about objects; beside it nothing is
        if (const gl::Texture2D& texture = pane.picture().texture)
            places.take(fittedPicture(imVec(texture.size()), shown.area), FreePlaces::kObject);
        return places;
    }
    if (!pane.showsTheEyesView()) takeOutsideSigns(places, ui, pane, *view, theme);
    const scene::Scene& scene = *ui.bench.shownScene();
    const std::vector<scene::Bounds>& bounds = ui.bench.bounds();
    const float most = kFillsPane * area.size().x * area.size().y;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (bounds[i].isEmpty()) continue;
        const std::vector<PlaceBox> boxes = boxesOf(seenHull(*view, scene.objects[i]), area, kStripEm * theme.em, kRimEm * theme.em);
        float covered = 0;
        for (const PlaceBox& box : boxes)
            covered += box.size().x * box.size().y;
        if (covered >= most && isGround(bounds, i)) continue;
        for (const PlaceBox& box : boxes)
            places.take(box, FreePlaces::kObject);
    }
    return places;
}

} // namespace shadowlab::window
