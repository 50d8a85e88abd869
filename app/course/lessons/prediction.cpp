// SPDX-License-Identifier: MIT
#include "app/course/lessons/prediction.h"

#include <algorithm>
#include <stdexcept>

namespace shadowlab::course {

void Prediction::paint(const dvec2& at, double radius, bool on) {
    const double height = kPredictionSize.y;
    const dvec2 middle = at * dvec2(kPredictionSize);
    for (int y = 0; y < kPredictionSize.y; ++y)
        for (int x = 0; x < kPredictionSize.x; ++x)
            if (glm::length(dvec2(x + 0.5, y + 0.5) - middle) <= radius * height) cells_[index(x, y)] = on ? 1 : 0;
}

bool Prediction::isEmpty() const {
    return std::ranges::all_of(cells_, [](std::uint8_t cell) { return cell == 0; });
}

PredictionScore scorePrediction(const Prediction& prediction, const judge::Truth& truth) {
    if (truth.size != kPredictionSize) throw std::logic_error("the truth of a prediction has another size");
    using trace::Visibility;
    PredictionScore score;
    for (int y = 0; y < kPredictionSize.y; ++y)
        for (int x = 0; x < kPredictionSize.x; ++x) {
            const std::size_t i = truth.index(x, y);
            const Visibility visibility = truth.visibility[i];
            const bool painted = prediction.isPainted(x, y);
            PredictedCell cell = PredictedCell::left;
            if ((truth.ties.empty() || truth.ties[i] == 0) &&
                (visibility == Visibility::lit || visibility == Visibility::shadowed)) {
                const bool shadow = visibility == Visibility::shadowed;
                cell = shadow ? (painted ? PredictedCell::right : PredictedCell::missed)
                              : (painted ? PredictedCell::wrong : PredictedCell::none);
            }
            score.right += cell == PredictedCell::right ? 1 : 0;
            score.missed += cell == PredictedCell::missed ? 1 : 0;
            score.wrong += cell == PredictedCell::wrong ? 1 : 0;
            score.cells.push_back(cell);
        }
    return score;
}

} // namespace shadowlab::course
