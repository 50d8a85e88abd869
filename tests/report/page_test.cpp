// The page of a report: well formed, with all that it shows inside of it, whatever names it is given.
// SPDX-License-Identifier: MIT
#include "app/report/page/page.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "app/report/page/chart.h"
#include "app/report/page/chart_legend.h"
#include "tests/report/made_up.h"

namespace shadowlab::report {
namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

/// What lies between a tag and its end is no markup.
std::string without(std::string text, const std::string& tag) {
    for (std::size_t at = text.find("<" + tag + ">"); at != std::string::npos; at = text.find("<" + tag + ">")) {
        const std::size_t end = text.find("</" + tag + ">", at);
        if (end == std::string::npos) break;
        text.erase(at, end + tag.size() + 3 - at);
    }
    return text;
}

/// Every tag that is opened is closed, in turn. Returns how many there are.
int expectBalanced(const std::string& page) {
    const std::string html = without(without(page, "script"), "style");
    static const std::set<std::string> kVoid{"meta", "br"};
    std::vector<std::string> open;
    int count = 0;
    for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
        if (html[at + 1] == '!') continue;
        const std::size_t end = html.find('>', at);
        if (end == std::string::npos) {
            ADD_FAILURE() << "a tag without an end";
            return count;
        }
        const bool closes = html[at + 1] == '/', isWhole = html[end - 1] == '/';
        const std::size_t begin = at + (closes ? 2 : 1);
        const std::string name = html.substr(begin, html.find_first_of(" />\n", begin) - begin);
        EXPECT_EQ(std::count(html.begin() + static_cast<std::ptrdiff_t>(at),
                             html.begin() + static_cast<std::ptrdiff_t>(end), '"') %
                      2,
                  0)
            << html.substr(at, end - at);
        ++count;
        if (closes) {
            if (open.empty() || open.back() != name) {
                ADD_FAILURE() << "</" << name << "> ends " << (open.empty() ? "nothing" : open.back());
                return count;
            }
            open.pop_back();
        } else if (!isWhole && !kVoid.contains(name)) {
            open.push_back(name);
        }
    }
    EXPECT_TRUE(open.empty());
    return count;
}

std::vector<std::uint8_t> fromBase64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0, held = 0;
    for (const char c : text) {
        if (c == '=') break;
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos) return {};
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if ((held += 6) >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (held -= 8)));
    }
    return bytes;
}

TEST(ReportPageTest, IsBalancedAndEveryLinkHasItsEnd) {
    const std::string page = htmlPage(madeReport());
    EXPECT_GT(expectBalanced(page), 3000);
    std::set<std::string> ids;
    static const std::regex kId(R"re( id="([^"]*)")re"), kLink(R"re(href="#([^"]*)")re");
    for (auto it = std::sregex_iterator(page.begin(), page.end(), kId); it != std::sregex_iterator(); ++it)
        EXPECT_TRUE(ids.insert((*it)[1]).second) << (*it)[1] << " names two places";
    int links = 0;
    for (auto it = std::sregex_iterator(page.begin(), page.end(), kLink); it != std::sregex_iterator(); ++it, ++links)
        EXPECT_TRUE(ids.contains((*it)[1])) << (*it)[1];
    EXPECT_GE(links, 60 + 120); // a marker and two pictures for each of 60 points
}

TEST(ReportPageTest, EveryPictureIsInItOnceAndComesBackWhole) {
    const Report report = madeReport();
    std::set<std::vector<std::uint8_t>> expected, found;
    for (const Group& group : report.groups)
        for (const Point& point : group.points)
            expected.insert({point.picturePng, point.errorPng});
    const std::string page = htmlPage(report), begin = "data:image/png;base64,";
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
        const std::size_t from = at + begin.size();
        EXPECT_TRUE(found.insert(fromBase64(page.substr(from, page.find('"', from) - from))).second) << "written twice";
    }
    EXPECT_GE(found.size(), 10u);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(countOf(page, "<use href="), 120u);
}

// On a phone the chart's plot is cut out of its sheet; what else the sheet says stands below it as text.
TEST(ReportPageTest, APhoneHasTheWholeLegendAsText) {
    const Report report = madeReport();
    const std::string page = htmlPage(report);
    std::size_t from = 0;
    int labels = 0, numbered = 0;
    for (const Group& group : report.groups) {
        from = page.find("<div class=\"phone-legend\">", from + 1);
        ASSERT_NE(from, std::string::npos);
        const std::string legend = page.substr(from, page.find("</div>", from) - from);
        for (const Point& point : group.points) {
            EXPECT_NE(legend.find(point.key.technique), std::string::npos) << point.key.technique;
            if (point.key.varies.empty() || !hasPlace(point)) continue;
            EXPECT_NE(legend.find("<em>" + point.key.sweep + "</em>"), std::string::npos) << "a label in the chart";
            ++labels;
        }
        const std::size_t list = std::min(legend.find("<ol>"), legend.size());
        EXPECT_EQ(countOf(legend.substr(list), "<li>"), frontOf(group).size()) << "the numbers in the chart";
        numbered += static_cast<int>(frontOf(group).size());
    }
    EXPECT_GE(labels, 10);
    EXPECT_GE(numbered, 2);
    // The plot lies on the sheet, between the title above it and the legends beside it and below.
    const Chart chart = chartOf(report.groups[0], report.size);
    for (const Chart::Spot& spot : chart.spots) {
        const dvec2 place = (spot.place - chart.plotCorner) / chart.plotSize;
        EXPECT_TRUE(place.x > 0 && place.x < 1 && place.y > 0 && place.y < 1) << spot.point;
    }
    EXPECT_LT(chart.plotSize.x, 0.75 * kChartWidth) << "else its numbers are too small on a phone";
    EXPECT_EQ(countOf(page, "<div class=\"plot\" style=\"--wide: "), report.groups.size());
}

TEST(ReportPageTest, AsksNoNetwork) {
    const std::string page = htmlPage(madeReport());
    EXPECT_EQ(countOf(page, "http"), countOf(page, "xmlns=\"http://www.w3.org/2000/svg\"")); // a name, not an address
    EXPECT_EQ(countOf(page, "url("), 0u);
    EXPECT_EQ(countOf(page, "@import"), 0u);
    EXPECT_EQ(countOf(page, "src="), 0u);
}

TEST(ReportPageTest, HostileNamesAreText) {
    const std::string hostile = "</script><script>alert('1')</script>\" onload=\"x' & <b>";
    Report report = madeReport();
    report.machines[0] = {hostile, hostile, hostile, hostile, hostile, hostile, 1, 1, 1, 1};
    for (Group& group : report.groups) {
        group.scene = group.light = group.exactness.why = hostile;
        for (Growth& growth : group.growth)
            growth.technique = growth.sweep = growth.varies = hostile;
        for (Point& point : group.points) {
            point.key = {hostile, {hostile}, hostile, hostile, 1};
            point.command = hostile;
            point.errors.counters = {{hostile, hostile, 1, 2}};
            point.costs->passes = {{hostile, 1}};
        }
    }
    const std::string page = htmlPage(report);
    EXPECT_GT(expectBalanced(page), 3000);
    EXPECT_EQ(countOf(page, "<script"), 1u);
    EXPECT_EQ(countOf(page, "\" onload"), 0u);
    EXPECT_EQ(countOf(page, "<b> "), 0u);
    EXPECT_GE(countOf(page, "&lt;/script&gt;"), 60u);
}

TEST(ReportPageTest, TheSummaryTellsEveryVerdict) {
    Report report = madeReport();
    Group base = report.groups[0];
    report.groups.assign(6, base);
    report.groups[1].exactness = {19, 1, 1.7, 2.4, ""};
    report.groups[2].exactness = {{}, 1, 0, 0, ""};
    report.groups[3].exactness = {19, {}, 0, 0, ""};
    report.groups[4].exactness = {};
    report.groups[5].exactness.why = "";
    const std::string page = htmlPage(report);
    for (const char* words :
         {"In 1 of 3 comparisons", "more than 2 times</td>", "within 2 times</td>", "no exact point</td>",
          "all exact</td>", "nothing to compare</td>", "the reason is not known"})
        EXPECT_NE(page.find(words), std::string::npos) << words;
    EXPECT_NE(page.find(base.exactness.why), std::string::npos);
}

TEST(ReportPageTest, WhatHasNotBeenMeasuredIsTold) {
    Report report = madeReport();
    report.groups[1].points.clear();
    report.groups[1].exactness = {};
    report.groups[1].growth.clear();
    Point& point = report.groups[0].points[4];
    point.costs.reset();
    point.picturePng.clear();
    point.errorPng = {'G', 'I', 'F'};
    report.machines.clear();
    const std::string page = htmlPage(report);
    EXPECT_GT(expectBalanced(page), 1500);
    EXPECT_NE(page.find("not measured yet"), std::string::npos);
    EXPECT_NE(page.find("No technique has been measured here"), std::string::npos);
    EXPECT_EQ(countOf(page, "No picture was kept"), 2u);
    EXPECT_GT(expectBalanced(htmlPage({})), 20);
}

TEST(ReportPageTest, RowsHaveAsManyCellsAsHeads) {
    const std::string page = htmlPage(madeReport());
    std::size_t heads = 0, rows = 0;
    const std::string text = std::regex_replace(page, std::regex("\n"), " ");
    for (std::size_t at = text.find("<tr>"); at != std::string::npos; at = text.find("<tr>", at + 1)) {
        const std::string row = text.substr(at, text.find("</tr>", at) - at);
        const std::size_t cells = countOf(row, "<td") + countOf(row, "<th ");
        if (countOf(row, "<td") == 0) {
            heads = cells;
            continue;
        }
        EXPECT_EQ(cells, heads) << row.substr(0, 200);
        ++rows;
    }
    EXPECT_GE(rows, 2u + 60 + 4 + 1); // summary, points, growth, machine
    EXPECT_EQ(countOf(page, "colspan=\"14\""), 60u);
}

TEST(ReportPageTest, TheSameReportGivesTheSameBytes) { EXPECT_EQ(htmlPage(madeReport()), htmlPage(madeReport())); }

} // namespace
} // namespace shadowlab::report
