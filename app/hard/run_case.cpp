// SPDX-License-Identifier: MIT
#include "app/hard/run_case.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>

#include "app/hard/judged_scene.h"
#include "app/hard/quantities.h"

namespace shadowlab::hard {

namespace {

using session::ShownState;

/// The pixels of which the visibility, grey and alpha, is not the same.
int differingPixels(const session::VisibilityImage& a, const session::VisibilityImage& b) {
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

class CaseRun {
public:
    CaseRun(const Case& one, bool small) : case_(one), size_(small ? one.smallSize : one.size) {}

    Row row(const Check& check) {
        Row row{case_.id,
                check.title,
                check.right.slots.front().technique,
                check.settings,
                check.naiveSettings,
                {},
                {},
                {},
                {},
                0};
        const JudgedFrame right = draw(check.right);
        row.counts = right.errors.judgement.counts;
        row.ms = right.ms;
        std::optional<JudgedFrame> naive;
        if (check.naive) naive = draw(*check.naive);
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
        const Least least = leastHere();
        if (!std::ranges::all_of(row.measured, &Measured::holds))
            row.outcome = Outcome::wrong;
        else if (row.counts.lit < least.lit || row.counts.shadowed < least.shadowed)
            row.outcome = Outcome::provesNothing;
        return row;
    }

private:
    /// The case's numbers are those of its full size.
    [[nodiscard]] Least leastHere() const {
        const double share =
            static_cast<double>(size_.x) * size_.y / (static_cast<double>(case_.size.x) * case_.size.y);
        return {static_cast<int>(case_.least.lit * share), static_cast<int>(case_.least.shadowed * share)};
    }
    JudgedFrame draw(const ShownState& state) {
        auto found = std::ranges::find_if(scenes_, [&](const auto& scene) { return scene->shows(state); });
        if (found == scenes_.end()) {
            scenes_.push_back(std::make_unique<JudgedScene>(state, size_));
            found = std::prev(scenes_.end());
        }
        return (*found)->draw(state.slots.front());
    }
    double value(const Expectation& expected, const JudgedFrame& frame) {
        const measure::Counts& counts = frame.errors.judgement.counts;
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
    std::vector<std::unique_ptr<JudgedScene>> scenes_; ///< each with the truth of its own
};

} // namespace

std::string_view toText(Outcome outcome) {
    switch (outcome) {
    case Outcome::right: return "right";
    case Outcome::wrong: return "wrong";
    case Outcome::provesNothing: return "proves nothing";
    }
    return "";
}

std::vector<Row> runCase(const Case& one, bool small) {
    CaseRun run(one, small);
    std::vector<Row> rows;
    for (const Check& check : one.checks)
        rows.push_back(run.row(check));
    return rows;
}

} // namespace shadowlab::hard
