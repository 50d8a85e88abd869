// The chart of cost and error: where its markers stand, by arithmetic of the test's own, and whether it can be read.
// SPDX-License-Identifier: MIT
#include "app/report/page/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "app/report/page/chart_legend.h"
#include "app/report/page/log_axis.h"
#include "app/report/page/technique_mark.h"
#include "tests/figures/written.h"
#include "tests/report/made_up.h"

namespace shadowlab::report {
namespace {

constexpr ivec2 kSize{320, 180};

/// A number that stands beside an axis, and where its middle lies along it.
using Ticks = std::map<double, double>;

bool isNumber(const std::string& text) { return text.find_first_not_of("0123456789.e-") == std::string::npos; }

/// Ticks are told from the numbers of the front by their places: below and to the left of the frame.
struct ReadAxes {
    Ticks costs, errors;
    explicit ReadAxes(const drawing::Drawing& drawing) {
        double left = 0, bottom = 0;
        for (const drawing::Mark& mark : drawing.marks())
            if (const auto* frame = std::get_if<drawing::Rectangle>(&mark)) {
                left = frame->corner.x;
                bottom = frame->corner.y + frame->size.y;
            }
        for (const drawing::Mark& mark : drawing.marks())
            if (const auto* text = std::get_if<drawing::TextLine>(&mark); text && isNumber(text->text)) {
                if (text->place.x < left && text->place.y < bottom)
                    errors[std::stod(text->text)] =
                        text->place.y - 8; // the foot of digits is 8 pixels below their middle
                if (text->style.anchor == drawing::Anchor::middle) costs[std::stod(text->text)] = text->place.x;
            }
    }
};

/// Between the first and the last tick, in logarithms.
double placeBetween(const Ticks& ticks, double value) {
    const auto [lowValue, low] = *ticks.begin();
    const auto [highValue, high] = *ticks.rbegin();
    return low + (high - low) * std::log(value / lowValue) / std::log(highValue / lowValue);
}

/// Is there a shape in that colour whose middle is there? A triangle's is that of its corners.
bool hasMarker(const drawing::Drawing& drawing, dvec2 place, const std::string& color) {
    for (const drawing::Mark& mark : drawing.marks()) {
        dvec2 middle(0);
        if (const auto* circle = std::get_if<drawing::Circle>(&mark); circle && circle->fill == color) {
            middle = circle->centre;
        } else if (const auto* shape = std::get_if<drawing::Line>(&mark); shape && shape->fill == color) {
            for (const dvec2 corner : shape->points)
                middle += corner / static_cast<double>(shape->points.size());
        } else {
            continue;
        }
        if (glm::distance(middle, place) < 0.01) return true;
    }
    return false;
}

/// No two texts share a place, and none leaves the sheet. Returns how many there are.
std::size_t expectReadable(const Group& group) {
    const Chart chart = chartOf(group, kSize);
    std::vector<figures::Written> all = figures::written(chart.drawing.document("chart"));
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].box.corner.x += 1; // widths are measured in whole pixels
        all[i].box.size.x -= 2;
        EXPECT_GE(all[i].em, kChartType) << all[i].text;
        EXPECT_GE(all[i].box.corner.x, 0) << all[i].text;
        EXPECT_GE(all[i].box.corner.y, 0) << all[i].text;
        EXPECT_LE(all[i].box.corner.x + all[i].box.size.x, kChartWidth) << all[i].text;
        EXPECT_LE(all[i].box.corner.y + all[i].box.size.y, chart.drawing.size().y) << all[i].text;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(all[i].box.overlaps(all[j].box)) << all[i].text << " covers " << all[j].text;
    }
    return all.size();
}

// A sweep's title stands in the chart where there is room; in the legend all of them stand, below their technique.
TEST(ReportChartTest, EveryLabelIsInTheLegend) {
    const Group group = madeGroup("still-life");
    const Chart chart = chartOf(group, kSize);
    double frameRight = 0;
    for (const drawing::Mark& mark : chart.drawing.marks())
        if (const auto* frame = std::get_if<drawing::Rectangle>(&mark))
            frameRight = std::max(frameRight, frame->corner.x + frame->size.x);
    std::multiset<std::string> inChart, inLegend;
    for (const drawing::Mark& mark : chart.drawing.marks())
        if (const auto* text = std::get_if<drawing::TextLine>(&mark); text && text->style.isItalic)
            (text->place.x > frameRight ? inLegend : inChart).insert(text->text);
    for (const std::string& label : inChart)
        EXPECT_TRUE(inLegend.contains(label)) << label;
    EXPECT_GE(inChart.size(), 2u);
    std::set<std::pair<std::string, std::string>> named;
    for (const Point& point : group.points)
        if (!point.key.varies.empty() && hasPlace(point)) named.insert({point.key.technique, point.key.sweep});
    EXPECT_EQ(inLegend.size(), named.size());
}

TEST(ReportChartTest, LettersAreLargeEnoughInPrint) {
    constexpr double kPointsPerCentimetre = 72 / 2.54;
    EXPECT_GE(kChartType / kChartWidth * 16 * kPointsPerCentimetre, 8);
}

TEST(ReportChartTest, MarkersStandWhereTheLogarithmsSay) {
    const Group group = madeGroup("still-life");
    const Chart chart = chartOf(group, kSize);
    const ReadAxes axes(chart.drawing);
    ASSERT_GE(axes.costs.size(), 4u);
    ASSERT_GE(axes.errors.size(), 4u);
    const auto marks = marksOf(group);
    ASSERT_EQ(chart.spots.size(), group.points.size());
    int placed = 0, exact = 0;
    std::set<double> zeroRows;
    for (const Chart::Spot& spot : chart.spots) {
        const Point& point = group.points[spot.point];
        // Places are doubles, and ticks lie on powers of ten: a hundredth of a pixel is rounding's share many times over.
        EXPECT_NEAR(spot.place.x, placeBetween(axes.costs, point.costs->frame.median), 0.01) << point.key.name();
        if (*point.errors.edgeErrorPx > 0) {
            EXPECT_NEAR(spot.place.y, placeBetween(axes.errors, *point.errors.edgeErrorPx), 0.01) << point.key.name();
            ++placed;
        } else {
            EXPECT_GT(spot.place.y, axes.errors.begin()->second + 10) << point.key.name();
            zeroRows.insert(spot.place.y);
            ++exact;
        }
        const bool isOpen = point.errors.served < 1;
        EXPECT_TRUE(hasMarker(chart.drawing, spot.place, isOpen ? "#ffffff" : marks.at(point.key.technique).color))
            << point.key.name();
    }
    EXPECT_GE(placed, 15);
    EXPECT_GE(exact, 8);
    EXPECT_EQ(zeroRows.size(), 1u);
}

TEST(ReportChartTest, WhereTheAreaIsJudgedTheAxisIsThatOfRmse) {
    Group group = madeGroup("still-life");
    group.truth = judge::TruthOf::area;
    for (Point& point : group.points)
        point.errors.truth = group.truth;
    const double halfStep = 0.5 / 255; // of a picture with 255 steps: less is rounding
    group.points[2].errors.falseLit = 0;
    group.points[2].errors.rmse = 0.9 * halfStep;
    group.points[3].errors.falseLit = 0;
    group.points[3].errors.rmse = 1.1 * halfStep;
    const Chart chart = chartOf(group, kSize);
    const ReadAxes axes(chart.drawing);
    int placed = 0;
    for (const Chart::Spot& spot : chart.spots)
        if (const double rmse = group.points[spot.point].errors.rmse; rmse > halfStep) {
            EXPECT_NEAR(spot.place.y, placeBetween(axes.errors, rmse), 0.01); // as above
            ++placed;
        }
    EXPECT_GE(placed, 15);
    EXPECT_GT(chart.spots[2].place.y, axes.errors.begin()->second + 10);
    EXPECT_LE(chart.spots[3].place.y, axes.errors.begin()->second);
    const std::string svg = chart.drawing.document("chart");
    EXPECT_NE(svg.find("RMSE of visibility"), std::string::npos);
    EXPECT_NE(svg.find("share of the light"), std::string::npos);
    EXPECT_EQ(svg.find(" px<"), std::string::npos);
}

TEST(ReportChartTest, IntervalsReachFromTheirLowerToTheirUpperEnd) {
    Group group = madeGroup("still-life");
    group.points[3].costs->frame = {3.6, 2.1, 5.9, 7};
    const Chart chart = chartOf(group, kSize);
    const ReadAxes axes(chart.drawing);
    const double y = chart.spots[3].place.y;
    int found = 0;
    for (const drawing::Mark& mark : chart.drawing.marks())
        if (const auto* bar = std::get_if<drawing::Segments>(&mark))
            found += bar->points.size() == 6 && std::abs(bar->points[0].y - y) < 1e-9 &&
                     std::abs(bar->points[0].x - placeBetween(axes.costs, 2.1)) < 0.01 &&
                     std::abs(bar->points[1].x - placeBetween(axes.costs, 5.9)) < 0.01;
    EXPECT_EQ(found, 1);
}

TEST(ReportChartTest, TextsDoNotCoverEachOther) { EXPECT_GE(expectReadable(madeGroup("still-life")), 40u); }

TEST(ReportChartTest, LongAndHostileNamesStayWithinTheSheet) {
    Group group =
        madeGroup("<script>alert(\"1\")</script> & a name that is much longer than any sheet of paper is wide, äöü");
    for (Point& point : group.points) {
        point.key.technique += "-of-a-plug-in-with-a-very-long-name";
        point.key.settings.push_back(
            "note=<b>\"quoted\"</b> and longer than the line that it is told in, by quite a few words");
    }
    EXPECT_GE(expectReadable(group), 40u);
    const std::string svg = costErrorChart(group, kSize);
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_NE(svg.find("&lt;script"), std::string::npos);
    EXPECT_EQ(svg.find("<b>"), std::string::npos);
}

TEST(ReportChartTest, GroupsWithLittleInThemAreDrawn) {
    const Group empty{"still-life", "key", judge::TruthOf::centre, {}, {}, {}};
    EXPECT_NE(costErrorChart(empty, kSize).find("no point has been measured"), std::string::npos);
    EXPECT_GE(expectReadable(empty), 8u);

    Group one = empty;
    one.points.push_back(madePoint("shadow-map", {}, 1, 1)); // on a tick of both axes
    one.points[0].onFront = true;
    EXPECT_EQ(chartOf(one, kSize).spots.size(), 1u);
    EXPECT_GE(expectReadable(one), 12u);

    Group exact = empty;
    for (int i = 0; i < 12; ++i)
        exact.points.push_back(
            madePoint("ray-traced", {"threads=" + std::to_string(i)}, 4, 0)); // all cost the same, too
    EXPECT_EQ(chartOf(exact, kSize).spots.size(), 12u);
    for (Point& point : exact.points)
        point.onFront = true;
    EXPECT_GE(expectReadable(exact), 20u);
    for (const Group* group : std::initializer_list<const Group*>{&empty, &one, &exact}) {
        const ReadAxes axes(chartOf(*group, kSize).drawing);
        for (const Ticks* ticks : {&axes.costs, &axes.errors})
            EXPECT_GE(ticks->rbegin()->first / ticks->begin()->first, 9.99) << "less than a decade";
    }
}

TEST(ReportChartTest, PointsWithoutAPlaceAreCounted) {
    Group group = madeGroup("still-life");
    group.points[2].costs.reset();
    group.points[3].errors.edgeErrorPx.reset(); // wrong pixels, and no boundary
    group.points[4].costs->frame.median = std::nan("");
    EXPECT_EQ(chartOf(group, kSize).spots.size(), group.points.size() - 3);
    EXPECT_NE(costErrorChart(group, kSize).find("3 of 30 points have no place"), std::string::npos);
    EXPECT_GE(expectReadable(group), 40u);
    EXPECT_EQ(costErrorChart(group, kSize).find("nan"), std::string::npos);
}

TEST(ReportChartTest, TheFrontIsAStairThroughItsPoints) {
    const Group group = madeGroup("still-life");
    const Chart chart = chartOf(group, kSize);
    std::vector<dvec2> corners;
    for (const Chart::Spot& spot : chart.spots)
        if (group.points[spot.point].onFront) corners.push_back(spot.place);
    ASSERT_GE(corners.size(), 4u);
    int stairs = 0;
    for (const drawing::Mark& mark : chart.drawing.marks())
        if (const auto* line = std::get_if<drawing::Line>(&mark);
            line && line->points.size() == 2 * corners.size() + 1) {
            ++stairs;
            for (std::size_t i = 1; i < line->points.size(); ++i) {
                const dvec2 step = line->points[i] - line->points[i - 1];
                EXPECT_TRUE(std::abs(step.x) < 1e-9 || std::abs(step.y) < 1e-9); // along one axis
                EXPECT_TRUE(step.x > -1e-9 && step.y > -1e-9);                   // never back, never up
            }
            for (const dvec2 corner : corners)
                EXPECT_EQ(std::ranges::count(line->points, corner), 1);
        }
    EXPECT_EQ(stairs, 1);
}

TEST(ReportChartTest, TechniquesDifferInColourAndInShape) {
    const Group group = madeGroup("still-life");
    std::set<std::string> colors;
    std::set<int> shapes;
    const auto marks = marksOf(group);
    for (const auto& [technique, mark] : marks) {
        colors.insert(mark.color);
        shapes.insert(mark.shape);
    }
    EXPECT_EQ(marks.size(), 8u);
    EXPECT_EQ(colors.size(), 8u);
    EXPECT_EQ(shapes.size(), 8u);

    Group many;
    std::set<std::pair<std::string, int>> pairs;
    for (int i = 0; i < 64 - 8; ++i)
        many.points.push_back(madePoint("plug-in-" + std::to_string(i), {}, 1, 1));
    for (const auto& [technique, mark] : marksOf(many))
        pairs.insert({mark.color, mark.shape});
    EXPECT_EQ(pairs.size(), 56u);
}

TEST(ReportChartTest, TheSameGroupGivesTheSameBytes) {
    EXPECT_EQ(costErrorChart(madeGroup("still-life"), kSize), costErrorChart(madeGroup("still-life"), kSize));
}

TEST(ReportChartTest, AxesEndAtOneTwoOrFive) {
    const double values[] = {0.013, 0.9, 0, -3, std::nan(""), INFINITY};
    const LogAxis axis(values, 100, 700);
    EXPECT_DOUBLE_EQ(axis.low(), 0.01);
    EXPECT_DOUBLE_EQ(axis.high(), 1);
    EXPECT_DOUBLE_EQ(axis.place(0.1), 400);
    EXPECT_DOUBLE_EQ(axis.place(0), 100);
    std::string texts;
    for (const LogAxis::Tick& tick : axis.ticks(60))
        texts += tick.text + " ";
    EXPECT_EQ(texts, "0.01 0.02 0.05 0.1 0.2 0.5 1 ");
    EXPECT_EQ(axis.grid().size(), 19u); // 0.01 to 0.09, 0.1 to 0.9, 1

    const double wide[] = {3e-9, 7e8};
    texts.clear();
    for (const LogAxis::Tick& tick : LogAxis(wide, 0, 600).ticks(60))
        texts += tick.text + " ";
    EXPECT_EQ(texts, "1e-8 1e-6 0.0001 0.01 1 100 10000 1e6 1e8 ");
}

TEST(ReportChartTest, NumbersHaveThreeDigits) {
    EXPECT_EQ(threeDigits(0.012345), "0.0123");
    EXPECT_EQ(threeDigits(12.345), "12.3");
    EXPECT_EQ(threeDigits(1234.5), "1234");
    EXPECT_EQ(threeDigits(0), "0");
    EXPECT_EQ(threeDigits(-0.0), "0");
    EXPECT_EQ(threeDigits(std::nan("")), "-");
}

} // namespace
} // namespace shadowlab::report
