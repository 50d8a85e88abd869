// "Predict, then reveal": the class paints where the shadow will be before it is shown; this scores what was painted.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "app/judge/truth.h"

namespace shadowlab::course {

/// A coarse picture in the aspect ratio of lessons (16:9), as fine as one can paint with a mouse.
constexpr ivec2 kPredictionSize{160, 90};

class Prediction {
public:
    /// Paints, or wipes, all cells whose middle lies in a disc; `at` in shares of the picture, `radius` as a share of its height.
    void paint(const dvec2& at, double radius, bool on);
    [[nodiscard]] bool isPainted(int x, int y) const { return cells_[index(x, y)] != 0; }
    [[nodiscard]] bool isEmpty() const;
    void clear() { cells_.assign(cells_.size(), 0); }

private:
    static std::size_t index(int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(kPredictionSize.x) + static_cast<std::size_t>(x);
    }
    std::vector<std::uint8_t> cells_ = std::vector<std::uint8_t>(index(0, kPredictionSize.y));
};

/// The score of one cell.
enum class PredictedCell : std::uint8_t {
    none,   ///< lit, and not painted
    right,  ///< in shadow, and painted
    missed, ///< in shadow, and not painted
    wrong,  ///< lit, and painted
    left,   ///< not judged: a tie, turned away from the light, or no surface
};

struct PredictionScore {
    std::vector<PredictedCell> cells; ///< rows from the top
    int right = 0, missed = 0, wrong = 0;
    /// Of what was painted, the share that is in shadow; of the shadow, the share that was painted. 0 where there is nothing
    /// to take a share of.
    [[nodiscard]] double paintedRight() const { return share(right, right + wrong); }
    [[nodiscard]] double shadowFound() const { return share(right, right + missed); }

private:
    static double share(int part, int whole) { return whole > 0 ? static_cast<double>(part) / whole : 0.0; }
};

/// `truth` has kPredictionSize. Only cast shadows count. The sides that are turned away from the light need not be painted, and
/// painting over them costs nothing.
PredictionScore scorePrediction(const Prediction& prediction, const judge::Truth& truth);

} // namespace shadowlab::course
