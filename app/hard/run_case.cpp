// SPDX-License-Identifier: MIT
#include "app/hard/run_case.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>

#include "app/hard/judged_scene.h"
#include "app/hard/quantities.h"
#include "app/report/judge.h"
#include "app/report/store.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::hard {

namespace {

using course::ShownState;

/// The pixels of which the visibility, grey and alpha, is not the same.
int differingPixels(const picture::VisibilityImage& a, const picture::VisibilityImage& b) {
    int differing = 0;
    for (std::size_t i = 0; i < a.greyAlpha.size(); i += 2)
        differing += a.greyAlpha[i] != b.greyAlpha[i] || a.greyAlpha[i + 1] != b.greyAlpha[i + 1] ? 1 : 0;
    return differing;
}

/// Largest difference of a channel, or the number of pixels that are not the same bytes.
double difference(const image::Image& a, const image::Image& b, bool largest) {
    int differing = 0, most = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const image::Color8 p = a.at(x, y), q = b.at(x, y);
            for (const int channel : {p.r - q.r, p.g - q.g, p.b - q.b})
                most = std::max(most, std::abs(channel));
            differing += p == q ? 0 : 1;
        }
    return largest ? most : differing;
}

Pictures picturesOf(const std::string& name, const JudgedFrame& frame) {
    return {report::fileName(name), image::encodePng(report::reduced(frame.picture)), image::encodePng(frame.errorMap)};
}

class CaseRun {
public:
    CaseRun(const Case& one, bool small) : case_(one), size_(small ? one.smallSize : one.size) {}

    Row row(const Check& check) {
        Row row;
        row.caseId = case_.id, row.title = check.title, row.technique = check.right.slots.front().technique;
        row.settings = check.settings, row.naiveSettings = check.naiveSettings;
        const std::string name = case_.id + "-check-" + std::to_string(++checks_);
        const JudgedFrame right = draw(check.right);
        row.counts = right.errors.judgement.counts;
        row.ms = right.ms;
        row.right = picturesOf(name, right);
        std::optional<JudgedFrame> naive;
        if (check.naive) {
            naive = draw(*check.naive);
            row.naive = picturesOf(name + "-careless", *naive);
        }
        for (const Expectation& expected : check.expectations) {
            Measured measured{
                expected.quantity, std::string(quantity(expected.quantity).unit), expected.bound.text(), 0, {}};
            measured.value = value(expected, right);
            measured.holds = expected.bound.holds(measured.value);
            if (naive) {
                measured.naive = value(expected, *naive);
                measured.naiveHolds = expected.bound.holds(*measured.naive);
            }
            row.measured.push_back(measured);
        }
        if (naive) row.caught = !std::ranges::all_of(row.measured, &Measured::naiveHolds);
        if (!std::ranges::all_of(row.measured, &Measured::holds))
            row.outcome = Outcome::wrong;
        else if (!isEnough(row.counts))
            row.outcome = Outcome::provesNothing;
        return row;
    }

    Cell cell(const Column& column) {
        Cell cell;
        cell.column = column.title(), cell.isExact = column.isExact;
        ShownState state = *case_.picture;
        state.slots = {column.state()};
        try {
            const JudgedFrame frame = sceneOf(state).draw(state.slots.front(), JudgedScene::Timing::again);
            cell.counts = frame.errors.judgement.counts;
            cell.coreErrors = frame.coreErrors, cell.served = frame.served, cell.ms = frame.ms;
            cell.pictures = picturesOf(case_.id + "-" + cell.column, frame);
        } catch (const Error& refusal) {
            cell.standing = Standing::refused;
            cell.reason = refusal.what();
            return cell;
        }
        // A core error is a wrong pixel; a stray one has no boundary to lie beside.
        const bool hasCore = cell.coreErrors > 0 || cell.counts.stray > 0;
        if (!isEnough(cell.counts))
            cell.standing = Standing::provesNothing;
        else
            cell.standing = hasCore ? Standing::wrong : cell.wrong() > 0 ? Standing::edges : Standing::exact;
        for (const Limit& limit : case_.limits)
            if (limit.slot == state.slots.front() && cell.standing == Standing::wrong) cell.reason = limit.why;
        return cell;
    }

private:
    [[nodiscard]] bool isEnough(const judge::Counts& counts) const {
        const Least least = leastHere();
        return counts.lit >= least.lit && counts.shadowed >= least.shadowed;
    }
    /// The case's numbers are those of its full size.
    [[nodiscard]] Least leastHere() const {
        const double share =
            static_cast<double>(size_.x) * size_.y / (static_cast<double>(case_.size.x) * case_.size.y);
        return {static_cast<int>(case_.least.lit * share), static_cast<int>(case_.least.shadowed * share)};
    }
    JudgedScene& sceneOf(const ShownState& state) {
        auto found = std::ranges::find_if(scenes_, [&](const auto& scene) { return scene->shows(state); });
        if (found == scenes_.end()) {
            scenes_.push_back(std::make_unique<JudgedScene>(state, size_));
            found = std::prev(scenes_.end());
        }
        return **found;
    }
    JudgedFrame draw(const ShownState& state) { return sceneOf(state).draw(state.slots.front()); }
    double value(const Expectation& expected, const JudgedFrame& frame) {
        const judge::Counts& counts = frame.errors.judgement.counts;
        const std::string& id = expected.quantity;
        if (id == "wrong") return counts.wrong() + counts.stray;
        if (id == "falseLit") return counts.falseLit;
        if (id == "falseShadow") return counts.falseShadow;
        if (id == "coreErrors") return frame.coreErrors;
        const JudgedFrame other = draw(*expected.from);
        if (id == "visibilityDiffers") return differingPixels(frame.visibility, other.visibility);
        return difference(frame.picture, other.picture, id == "largestDifference");
    }

    const Case& case_;
    ivec2 size_;
    int checks_ = 0;
    std::vector<std::unique_ptr<JudgedScene>> scenes_; ///< each with the truth of its own
};

} // namespace

CaseResult runWholeCase(const Case& one, bool small, std::span<const Column> columns) {
    CaseResult result{one.id, one.title, one.why, {}, {}, one.tests, one.naiveTests, one.withoutNaive};
    CaseRun run(one, small);
    for (const Check& check : one.checks)
        result.rows.push_back(run.row(check));
    if (one.picture)
        for (const Column& column : columns)
            result.cells.push_back(run.cell(column));
    return result;
}

std::vector<Row> runCase(const Case& one, bool small) { return runWholeCase(one, small, {}).rows; }

} // namespace shadowlab::hard
