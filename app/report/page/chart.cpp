// SPDX-License-Identifier: MIT
#include "app/report/page/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "app/context/assets.h"
#include "app/drawing/labels.h"
#include "app/report/page/chart_legend.h"
#include "app/report/page/log_axis.h"
#include "app/report/page/technique_mark.h"

namespace shadowlab::report {

namespace {

using drawing::Anchor;
using drawing::Drawing;

// The sheet, in pixels. What stands beside the axes is kChartType high; the left margin holds the words "wrong pixel".
constexpr double kLeft = 160, kRight = 860, kTop = 140, kBottom = 580, kZeroBottom = 644;
constexpr double kLegendLeft = 884, kMargin = 16;
constexpr double kAxisTitleTop = 94, kAxesEnd = kZeroBottom + 82; ///< what is written at the axes lies between
constexpr double kZero = 0.5 * (kBottom + kZeroBottom);
constexpr double kRoomX = 62, kRoomY = 30; ///< that the numbers of two ticks need: "0.005" is 60 pixels wide
constexpr double kRadius = 11;             ///< of markers
constexpr double kFrontAway = 15;          ///< pixels from a point to its number at least
constexpr double kSweepWidth = 260; ///< of the title of a sweep at most, which is the room that the legend has for it

drawing::TextStyle type(Anchor anchor, bool isBold = false, double size = kChartType) {
    return {size, anchor, isBold, false, "#000000", false};
}

std::vector<double> costsOf(const Group& group) {
    std::vector<double> costs;
    for (const Point& point : group.points)
        if (hasPlace(point))
            for (const double cost : {point.costs->frame.median, point.costs->frame.lower, point.costs->frame.upper})
                costs.push_back(cost);
    return costs;
}

std::vector<double> errorsOf(const Group& group) {
    std::vector<double> errors;
    for (const Point& point : group.points)
        if (hasPlace(point) && !isInZeroRow(point)) errors.push_back(point.errors.shown());
    return errors;
}

/// Draws one chart, from the back to the front.
class Writer {
public:
    Writer(const Group& group, const image::Font& font, double height)
        : group_(group), font_(font), drawing_({kChartWidth, height}), costs_(costsOf(group), kLeft, kRight),
          errors_(errorsOf(group), kBottom, kTop) {
        std::map<SweepName, std::vector<std::size_t>> members;
        for (std::size_t i = 0; i < group.points.size(); ++i)
            if (const Point& point = group.points[i]; hasPlace(point) && !point.key.varies.empty())
                members[{point.key.technique, point.key.sweep}].push_back(i);
        for (auto& [name, points] : members) {
            std::ranges::stable_sort(points, {}, [&](std::size_t i) { return group.points[i].key.value; });
            for (const std::size_t i : points)
                sweeps_[name].push_back(placeOf(group.points[i]));
        }
    }

    void title(ivec2 size) {
        const double width = kChartWidth - 2 * kMargin;
        drawing_.text({kMargin, 36}, fitted(font_, chartTitle(group_), 26, 0.88 * width),
                      type(Anchor::start, true, 26));
        const std::string judged = group_.truth == judge::TruthOf::area
                                       ? "judged by the share of the light's area that is seen"
                                       : "judged by the light's centre";
        drawing_.text({kMargin, 70},
                      judged + "; pictures of " + std::to_string(size.x) + " × " + std::to_string(size.y) + " pixels",
                      type(Anchor::start));
        drawing_.text({kMargin, 116},
                      group_.truth == judge::TruthOf::area ? "error: RMSE of visibility"
                                                           : "error: wrong pixels by length of shadow boundary [px]",
                      type(Anchor::start, true));
        drawing_.text({0.5 * (kLeft + kRight), kZeroBottom + 70}, "time of a frame, light moving [ms]",
                      type(Anchor::middle, true));
    }

    void axes() {
        std::vector<dvec2> fine, strong;
        for (const double cost : costs_.grid())
            fine.insert(fine.end(), {{costs_.place(cost), kTop}, {costs_.place(cost), kZeroBottom}});
        for (const double error : errors_.grid())
            fine.insert(fine.end(), {{kLeft, errors_.place(error)}, {kRight, errors_.place(error)}});
        for (const LogAxis::Tick& tick : costs_.ticks(kRoomX)) {
            strong.insert(strong.end(), {{costs_.place(tick.value), kTop}, {costs_.place(tick.value), kZeroBottom}});
            drawing_.text({costs_.place(tick.value), kZeroBottom + 32}, tick.text, type(Anchor::middle));
        }
        for (const LogAxis::Tick& tick : errors_.ticks(kRoomY)) {
            const double y = errors_.place(tick.value);
            strong.insert(strong.end(), {{kLeft, y}, {kRight, y}});
            drawing_.text({kLeft - 12, y + 8}, tick.text, type(Anchor::end));
        }
        drawing_.segments(fine, {"#ececec", 1, false});
        drawing_.segments(strong, {"#c4c4c4", 1.25, false});
        drawing_.text({kLeft - 12, kZero + 2}, "0: no", type(Anchor::end));
        drawing_.text({kLeft - 12, kZero + 28}, "wrong pixel", type(Anchor::end));
        drawing_.rectangle({kLeft, kTop}, {kRight - kLeft, kZeroBottom - kTop}, "", {"#000000", 2, false});
        drawing_.line({kLeft, kBottom}, {kRight, kBottom}, {"#000000", 2, false});
    }

    void sweeps(const std::map<std::string, TechniqueMark>& marks) {
        for (const auto& [name, places] : sweeps_)
            drawing_.path(places, false, "", {marks.at(name.first).color, 2, false});
    }

    void front() { drawing_.path(frontSteps(), false, "", {"#000000", 3, false}); }

    void intervals() {
        for (const Point& point : group_.points) {
            if (!hasPlace(point)) continue;
            const double y = placeOf(point).y;
            const dvec2 from(costs_.place(point.costs->frame.lower), y), to(costs_.place(point.costs->frame.upper), y);
            const dvec2 cap(0, 6);
            drawing_.segments(std::array{from, to, from - cap, from + cap, to - cap, to + cap}, {"#1a1a1a", 2, false});
        }
    }

    std::vector<Chart::Spot> markers(const std::map<std::string, TechniqueMark>& marks) {
        std::vector<Chart::Spot> spots;
        for (std::size_t i = 0; i < group_.points.size(); ++i)
            if (const Point& point = group_.points[i]; hasPlace(point)) {
                spots.push_back({i, placeOf(point)});
                drawMark(drawing_, spots.back().place, marks.at(point.key.technique), kRadius, point.errors.served < 1);
            }
        return spots;
    }

    /// The front's numbers, each beside its point, on no marker; where there is room, the titles of the sweeps.
    void labels(const std::vector<Chart::Spot>& spots) {
        drawing::Labels labels(font_, {{kLeft + 2, kTop + 2}, {kRight - kLeft - 4, kZeroBottom - kTop - 4}});
        for (const Chart::Spot& spot : spots) {
            labels.avoid({spot.place - kRadius, dvec2(2 * kRadius)});
            const Spread& frame = group_.points[spot.point].costs->frame;
            labels.avoid({costs_.place(frame.lower), spot.place.y}, {costs_.place(frame.upper), spot.place.y});
        }
        for (const auto& [name, places] : sweeps_)
            for (std::size_t i = 1; i < places.size(); ++i)
                labels.avoid(places[i - 1], places[i]);
        const std::vector<dvec2> steps = frontSteps();
        for (std::size_t i = 1; i < steps.size(); ++i)
            labels.avoid(steps[i - 1], steps[i]);
        labels.avoid({kLeft, kBottom}, {kRight, kBottom}); // below it, nothing is wrong
        int number = 0;
        for (const std::size_t i : frontOf(group_))
            labels.place(drawing_, placeOf(group_.points[i]), std::to_string(++number),
                         {kChartType, Anchor::start, true, false, "#000000", true}, kFrontAway);
        for (const auto& [name, places] : sweeps_)
            if (places.size() > 1 && !name.second.empty())
                labels.place(drawing_, places.back(), fitted(font_, name.second, kChartType, kSweepWidth),
                             {kChartType, Anchor::start, false, true, "#000000", true}, kFrontAway);
    }

    void notes() {
        const auto missing =
            group_.points.size() - static_cast<std::size_t>(std::ranges::count_if(group_.points, hasPlace));
        if (group_.points.size() == missing)
            drawing_.text({0.5 * (kLeft + kRight), 0.5 * (kTop + kBottom)}, "no point has been measured",
                          type(Anchor::middle));
        else if (missing > 0)
            drawing_.text({kMargin, kZeroBottom + 106},
                          std::to_string(missing) + " of " + std::to_string(group_.points.size()) +
                              " points have no place here: not measured, or no boundary to count by",
                          type(Anchor::start));
    }

    Drawing& drawing() { return drawing_; }

private:
    [[nodiscard]] dvec2 placeOf(const Point& point) const {
        return {costs_.place(point.costs->frame.median),
                isInZeroRow(point) ? kZero : errors_.place(point.errors.shown())};
    }

    /// Down and to the right: what can be had for a cost is the error of the last point that is not dearer.
    [[nodiscard]] std::vector<dvec2> frontSteps() const {
        std::vector<dvec2> steps;
        for (const std::size_t i : frontOf(group_)) {
            const dvec2 place = placeOf(group_.points[i]);
            steps.push_back({place.x, steps.empty() ? kTop : steps.back().y});
            steps.push_back(place);
        }
        if (!steps.empty()) steps.push_back({kRight, steps.back().y});
        return steps;
    }

    const Group& group_;
    const image::Font& font_;
    Drawing drawing_;
    LogAxis costs_, errors_;
    using SweepName = std::pair<std::string, std::string>; ///< of the technique, and of its sweep
    std::map<SweepName, std::vector<dvec2>> sweeps_;       ///< places of its points, in the order of what varies
};

} // namespace

std::string chartTitle(const Group& group) { return group.scene + ", light " + group.light + ": cost and error"; }

Chart chartOf(const Group& group, ivec2 size) {
    const image::Font font(context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
    constexpr double kLegendWidth = kChartWidth - kLegendLeft - kMargin;
    const bool hasNote = !std::ranges::all_of(group.points, hasPlace);
    // How high the sheet has to be is known once the words around the chart have been written. The legend may be longer than the
    // chart is high; what explains the front stands below both.
    Drawing around({kChartWidth, 0});
    const double legendEnd = drawLegend(around, group, font, {kLegendLeft, kTop}, kLegendWidth);
    const dvec2 keyPlace(kMargin, std::max(kZeroBottom + (hasNote ? 150 : 116), legendEnd + kMargin));
    const double height =
        kMargin + std::max({legendEnd, drawFrontKey(around, group, font, keyPlace, kChartWidth - 2 * kMargin),
                            kZeroBottom + (hasNote ? 110 : 76)});
    Writer writer(group, font, height);
    const std::map<std::string, TechniqueMark> marks = marksOf(group);
    writer.title(size);
    writer.axes();
    writer.sweeps(marks);
    writer.front();
    writer.intervals();
    std::vector<Chart::Spot> spots = writer.markers(marks);
    writer.labels(spots);
    writer.notes();
    drawLegend(writer.drawing(), group, font, {kLegendLeft, kTop}, kLegendWidth);
    drawFrontKey(writer.drawing(), group, font, keyPlace, kChartWidth - 2 * kMargin);
    return {std::move(writer.drawing()), std::move(spots), {0, kAxisTitleTop}, {kLegendLeft, kAxesEnd - kAxisTitleTop}};
}

std::string costErrorChart(const Group& group, ivec2 size) {
    return chartOf(group, size).drawing.document(chartTitle(group));
}

} // namespace shadowlab::report
