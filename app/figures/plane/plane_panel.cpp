// "Direct projection": the light, the caster, and where its shadow falls on the receiver's plane N.P + D = 0, as the plane
// through eye, light and point cuts them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/figure_drawers.h"
#include "app/figures/inks.h"
#include "app/figures/panels.h"
#include "app/figures/section_sheet.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/plane_probe.h"

namespace shadowlab::figures {

namespace {

const PlaneProbe& planeOf(const Probe& probe) { return *probe.find<PlaneProbe>(); }

using Cover = PlaneProbe::Cover;

constexpr const char* kPlaneShadow = "#1a1a1a";

/// The receiver's line in the drawing's plane, through the point: unit. None where the two planes are the same.
struct PlaneCut {
    dvec2 along{1, 0};
    dvec2 gradient{0.0}; ///< of the height N.P + D
    [[nodiscard]] double height(dvec2 place) const { return glm::dot(gradient, place); }
};
PlaneCut cutOf(const Probe& probe) {
    PlaneCut result;
    result.gradient = probe.section->ofDirection(dvec3(planeOf(probe).planeWorld));
    const double length = glm::length(result.gradient);
    if (length > 1e-9) result.along = dvec2(result.gradient.y, -result.gradient.x) / length;
    return result;
}

/// Metres along the receiver's line, from the point.
struct Interval {
    double from = 0, to = 0;
    dvec2 casterFrom{0.0}, casterTo{0.0}; ///< whose shadows are its ends
};

/// What of the line the casters shadow: their cuts between light and plane, projected, and joined where they touch.
std::vector<Interval> shadowsOn(const PlaneCut& plane, const SectionSheet& sheet, const Probe& probe,
                                const scene::Scene& scene) {
    const PlaneLight& light = sheet.light();
    const double lightHeight = light.isDirection ? plane.height(light.at) : plane.height(light.at);
    std::vector<Interval> all;
    if (lightHeight <= 0) return all;
    scene::Scene casters = scene;
    std::erase_if(casters.objects, [](const scene::Object& object) { return !object.castsShadow; });
    const LightSection& section = sheet.section();
    const std::vector<dvec2> points = cut(casters, {section.originWorld, section.rightWorld, section.upWorld});
    const double least = std::max(planeOf(probe).contact, 1e-9 * lightHeight),
                 most = light.isDirection ? 1e300 : 0.999 * lightHeight;
    const auto project = [&](dvec2 place) {
        const double h = plane.height(place);
        const dvec2 shadow = light.isDirection ? place - light.at * (h / lightHeight)
                                               : light.at + (place - light.at) * (lightHeight / (lightHeight - h));
        return glm::dot(shadow, plane.along);
    };
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        dvec2 a = points[i], b = points[i + 1];
        // Clipped as the technique clips: above the plane, below the light's height.
        double ha = plane.height(a), hb = plane.height(b);
        if (ha > hb) {
            std::swap(a, b);
            std::swap(ha, hb);
        }
        if (hb <= least || ha >= most) continue;
        if (ha < least) a = glm::mix(a, b, (least - ha) / (hb - ha));
        if (hb > most) b = glm::mix(a, b, (most - plane.height(a)) / (hb - plane.height(a)));
        Interval one{project(a), project(b), a, b};
        if (one.from > one.to) one = {one.to, one.from, b, a};
        all.push_back(one);
    }
    std::ranges::sort(all, {}, &Interval::from);
    std::vector<Interval> joined;
    for (const Interval& one : all) {
        const bool touches = !joined.empty() && one.from <= joined.back().to + 1e-6 * lightHeight;
        if (!touches)
            joined.push_back(one);
        else if (one.to > joined.back().to) {
            joined.back().to = one.to;
            joined.back().casterTo = one.casterTo;
        }
    }
    return joined;
}

/// The parts of the line on which there is a surface: what lies in the receiver's plane.
std::vector<Interval> surfacesOn(const PlaneCut& plane, const SectionSheet& sheet, const Probe& probe,
                                 const scene::Scene& scene) {
    const LightSection& section = sheet.section();
    const double least = std::max(planeOf(probe).contact, 1e-6 / sheet.scale());
    std::vector<Interval> all;
    const std::vector<dvec2> points = cut(scene, {section.originWorld, section.rightWorld, section.upWorld});
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        if (std::abs(plane.height(points[i])) > least || std::abs(plane.height(points[i + 1])) > least) continue;
        const double a = glm::dot(points[i], plane.along), b = glm::dot(points[i + 1], plane.along);
        all.push_back({std::min(a, b), std::max(a, b)});
    }
    return all;
}

void drawShadows(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet, const PlaneCut& plane,
                 std::span<const Interval> shadows, std::span<const Interval> surfaces) {
    const Interval* nearest = nullptr;
    const auto away = [](const Interval& one) { return one.from > 0 ? one.from : one.to < 0 ? -one.to : 0.0; };
    drawing.beginClip(sheet.area().corner, sheet.area().size);
    const double reach = 2 * glm::length(sheet.metres().size);
    drawing.line(sheet(-reach * plane.along), sheet(reach * plane.along), {"#a6a6a6", 2.5, false});
    for (const Interval& one : shadows) {
        bool falls = false; // on a surface, and not only on the plane's extension
        for (const Interval& surface : surfaces) {
            const double from = std::max(one.from, surface.from), to = std::min(one.to, surface.to);
            if (!(from < to)) continue;
            falls = true;
            drawing.line(sheet(from * plane.along), sheet(to * plane.along), {kPlaneShadow, 11, false});
        }
        if (falls && (!nearest || away(one) < away(*nearest))) nearest = &one;
    }
    if (nearest)
        for (const auto& [place, end] :
             {std::pair(nearest->casterFrom, nearest->from), std::pair(nearest->casterTo, nearest->to)}) {
            const dvec2 shadow = sheet(end * plane.along);
            const dvec2 from =
                sheet.light().isDirection ? sheet(place) + (sheet(place) - shadow) : sheet(sheet.light().at);
            drawing.line(from, shadow, {ink::kLight, 2.5, true});
            labels.avoid(from, shadow);
        }
    drawing.endClip();
    labels.avoid(sheet(-reach * plane.along), sheet(reach * plane.along));
}

/// From the light to the point.
void drawLightLine(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet, const Probe& probe) {
    const dvec2 point = sheet(dvec2(0.0));
    const PlaneLight& light = sheet.light();
    const bool lightIsSeen = !light.isDirection && sheet.shows(light.at);
    const dvec2 end = lightIsSeen ? sheet(light.at) : sheet.border(dvec2(0.0), light.toward(dvec2(0.0)));
    const bool shadowed = std::ranges::any_of(planeOf(probe).covers, &Cover::casts);
    const drawing::Stroke stroke{drawing::colorText(shadowed ? look::kOccluded : look::kEqualDepth), 4, false};
    drawing.arrow(end, point, stroke, 0.5);
    labels.avoid(end, point);
}

void drawCovers(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet, const Probe& probe) {
    constexpr double kApart = 12; // pixels: nearer, two faces that touch would be marked twice
    std::vector<dvec2> marked;
    for (const Cover& cover : planeOf(probe).covers) {
        if (std::abs(cover.height) <= planeOf(probe).contact) continue; // the plane itself
        const dvec2 place = sheet.section().of(cover.placeWorld), at = sheet(place);
        const bool isMarked =
            std::ranges::any_of(marked, [&](const dvec2& other) { return glm::length(other - at) < kApart; });
        if (isMarked || marked.size() == 8 || !sheet.shows(place)) continue;
        marked.push_back(at);
        drawing.circle(at, 8, cover.casts ? drawing::colorText(look::kOccluded) : "#ffffff",
                       {drawing::colorText(look::kOccluded), 3, false}, "cover");
        labels.avoid({at - 9.0, dvec2(18)});
        const bool first =
            cover.casts && std::ranges::find_if(planeOf(probe).covers, &Cover::casts)->placeWorld == cover.placeWorld;
        labels.place(drawing, at,
                     first               ? "P of " + cover.object
                     : cover.casts       ? cover.object
                     : cover.weight <= 0 ? "beyond the light: w' < 0"
                                         : "below the plane",
                     {.size = kText, .isBold = first}, 14);
    }
}

void drawNormal(drawing::Drawing& drawing, drawing::Labels& labels, const PlaneCut& plane, dvec2 from) {
    if (glm::length(plane.gradient) < 0.05) return; // it points out of the paper
    const dvec2 tip = from + 90.0 * dvec2(plane.gradient.x, -plane.gradient.y);
    drawing.arrow(from, tip, {ink::kNormal, 3.5, false});
    labels.avoid(from, tip);
    labels.place(drawing, tip, "N", {.size = drawing::kLetter, .isBold = true, .color = ink::kNormal}, 14);
}

void writePlaneNumbers(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const image::Font& font) {
    const PlaneProbe& plane = planeOf(probe);
    TextColumn column(drawing, area, font);
    column.heading("Receiver plane N\u00b7P + D = 0");
    const dvec4& p = plane.planeWorld;
    const auto shown = [](double value) { return fourDigits(std::round(value * 1e6) / 1e6); }; // floats have no more
    column.row("N = (" + fourDigits(p.x) + ", " + fourDigits(p.y) + ", " + fourDigits(p.z) + "), D = " + shown(p.w) +
               " m");
    const dvec4& l = plane.lightWorld;
    column.row("P_L = (" + fourDigits(l.x) + ", " + fourDigits(l.y) + ", " + fourDigits(l.z) + ", " + fourDigits(l.w) +
               ")");
    column.row("N\u00b7P_L + D = " + fourDigits(plane.lightHeight) + (l.w == 0 ? "" : " m"));
    column.heading("On the light's line");
    column.row("w' = (N\u00b7P_L + D) \u2212 (N\u00b7P + D)");
    bool any = false;
    std::vector<Cover> covers = plane.covers; // what casts comes first
    std::ranges::stable_partition(covers, &Cover::casts);
    std::size_t left = covers.size();
    for (const Cover& cover : covers) {
        --left;
        if (std::abs(cover.height) <= plane.contact) continue;
        any = true;
        if (!column.hasRoom(8)) {
            column.row("and " + std::to_string(left + 1) + " more triangles");
            break;
        }
        column.row("triangle " + std::to_string(cover.triangle) + " of " + cover.object +
                       ": N\u00b7P + D = " + fourDigits(cover.height) + " m, w' = " + fourDigits(cover.weight) + ": " +
                       (cover.casts         ? "it casts the shadow"
                        : cover.weight <= 0 ? "beyond the light"
                        : cover.height < 0  ? "below the plane"
                                            : "a hole"),
                   cover.casts ? "#a04000" : "#1a1a1a");
    }
    if (!any) column.row("no caster");
    column.heading("This technique");
    for (const Probe::Fact& fact : probe.facts)
        if (fact.label == "decision" || fact.label == "truth" || fact.label == "error")
            column.row(fact.label + ": " + fact.value, fact.label == "error" ? "#a04000" : "#1a1a1a");
}

} // namespace

void drawPlane(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
               const image::Font& font) {
    if (!planeOf(probe).receives) {
        drawNoPlane(drawing, area, probe, scene, font);
        return;
    }
    constexpr double kNumbers = 610, kLegend = 44;
    drawing.text(area.corner + dvec2(0, kHeading), "Direct projection in the plane through eye, light and point",
                 {.size = kHeading, .isBold = true});
    const drawing::Box field{area.corner + dvec2(0, kHeading + 18),
                    area.size - dvec2(kNumbers + 30, kHeading + 18 + kLegend + 14)};
    std::vector<dvec2> places;
    for (const Cover& cover : planeOf(probe).covers)
        places.push_back(probe.section->of(cover.placeWorld));
    const SectionSheet sheet(probe, scene, field, places);
    const PlaneCut plane = cutOf(probe);
    drawing::Labels labels(font, field);
    sheet.drawScene(drawing, labels);
    drawShadows(drawing, labels, sheet, plane, shadowsOn(plane, sheet, probe, scene),
                surfacesOn(plane, sheet, probe, scene));
    const dvec2 point = sheet(dvec2(0.0));
    const dvec2 eyeEnd = sheet.shows(sheet.eye()) ? sheet(sheet.eye()) : sheet.border(dvec2(0.0), sheet.eye());
    drawing.line(eyeEnd, point, {"#1a1a1a", 3, false});
    labels.avoid(eyeEnd, point);
    drawLightLine(drawing, labels, sheet, probe);
    drawNormal(drawing, labels, plane, sheet(dvec2(0.0)));
    sheet.drawPoint(drawing, labels, "P'");
    sheet.drawEye(drawing, labels);
    sheet.drawLight(drawing, labels);
    drawCovers(drawing, labels, sheet, probe); // last: its labels keep away from all lines
    drawing.rectangle(field.corner, field.size, "none", {"#bfbfbf", 2, false});
    writePlaneNumbers(drawing, {area.corner + dvec2(area.size.x - kNumbers, 0), {kNumbers, area.size.y - kLegend - 20}},
                      probe, font);
    using enum LegendEntry::Kind;
    const LegendEntry legend[] = {{line, kPlaneShadow, "projected shadow"},
                                  {dashed, ink::kLight, "its borders"},
                                  {line, drawing::colorText(look::kOccluded), "light that does not arrive"},
                                  {line, drawing::colorText(look::kEqualDepth), "light that does"},
                                  {line, "#4d4d4d", "caster"},
                                  {line, "#a6a6a6", "casts no shadow; the plane"}};
    drawLegend(drawing, {area.corner + dvec2(0, area.size.y - kLegend), {area.size.x, kLegend}}, legend, font);
}

Diagram drawProjection(const FigureSource& source) {
    const Probe& probe = source.probe;
    if (probe.geometry.empty()) throw Error(ExitStatus::badInput, "the pixel shows the background; choose another");
    if (!hasSection(probe) || !probe.find<PlaneProbe>() || !planeOf(probe).receives)
        throw Error(ExitStatus::badInput, std::string(source.technique) +
                                              " projects nothing onto that place; ask planar, about a pixel of a plane that "
                                              "receives shadows");
    drawing::Drawing drawing(source.size);
    const drawing::Box field{dvec2(kSectionBorder), source.size - 2 * kSectionBorder};
    std::vector<dvec2> places;
    for (const Cover& cover : planeOf(probe).covers)
        places.push_back(probe.section->of(cover.placeWorld));
    const SectionSheet sheet(probe, source.scene, field, places, source.mostPixelsPerMetre, false);
    const PlaneCut plane = cutOf(probe);
    const std::vector<Interval> shadows = shadowsOn(plane, sheet, probe, source.scene);
    drawing::Labels labels(source.fonts(), field);
    sheet.drawScene(drawing, labels);
    drawShadows(drawing, labels, sheet, plane, shadows, surfacesOn(plane, sheet, probe, source.scene));
    drawLightLine(drawing, labels, sheet, probe);
    // N and the plane's formula stand where the plane is bare: toward the border that is farther away.
    const dvec2 borders[] = {sheet.border(dvec2(0.0), plane.along), sheet.border(dvec2(0.0), -plane.along)};
    const dvec2 here = sheet(dvec2(0.0));
    const bool isFirst = glm::length(borders[0] - here) > glm::length(borders[1] - here);
    const dvec2 bare = glm::mix(here, borders[isFirst ? 0 : 1], 0.75);
    drawNormal(drawing, labels, plane, bare);

    const drawing::TextStyle letter{.size = drawing::kLetter, .isBold = true}, name{.size = kHeading};
    const dvec2 point = sheet(dvec2(0.0));
    const auto mark = [&](dvec2 at, double radius, const std::string& fill, const char* what) {
        drawing.circle(at, radius, fill, {"#1a1a1a", 3, false}, what);
        labels.avoid({at - radius - 2.0, dvec2(2 * radius + 4)});
    };
    mark(point, 9, "#1a1a1a", "point");
    const bool lightIsSeen = !sheet.light().isDirection && sheet.shows(sheet.light().at);
    if (lightIsSeen) mark(sheet(sheet.light().at), 15, drawing::colorText(look::kChosenLight), "light");
    // P: of the places above the point on the light's line the highest, where the line meets the caster first.
    const Cover* first = nullptr;
    for (const Cover& cover : planeOf(probe).covers)
        if (cover.casts && cover.height > planeOf(probe).contact && (!first || cover.height > first->height)) first = &cover;
    const dvec2 caster = first ? sheet(sheet.section().of(first->placeWorld)) : dvec2(0.0);
    if (first) mark(caster, 9, drawing::colorText(look::kOccluded), "cover");
    labels.place(drawing, point, "P\u2032", letter, 14);
    if (first) labels.place(drawing, caster, "P", letter, 14);
    if (lightIsSeen)
        labels.place(drawing, sheet(sheet.light().at), "$\\mathbf{P}_L$ light source", letter, 20);
    else
        sheet.drawLight(drawing, labels);
    labels.place(drawing, bare, "plane $\\mathbf{N} \\cdot \\mathbf{P}' + D = 0$", name, 20);
    // The shadow that holds the point, and what casts it, where the light's lines touch it.
    const auto own = std::ranges::find_if(shadows, [](const Interval& one) { return one.from <= 0 && one.to >= 0; });
    if (own != shadows.end() && first) {
        labels.place(drawing, sheet(own->to * plane.along), "projected shadow", name, 22);
        labels.place(drawing, sheet(own->casterTo), "object: " + first->object, name, 16);
    }
    return {std::move(drawing),
            "The light source, a point P of the caster, and P', where the line through both meets the receiver's plane",
            sheet.scale()};
}

} // namespace shadowlab::figures
