// SPDX-License-Identifier: MIT
#include "app/foreign/camera_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/quaternion.hpp>


namespace shadowlab::foreign {

namespace {

/// Of the fitted camera in the view space of the scene's: place (in units of the squares' distance), turn (a vector along its axis, radians), and the
/// logarithm of the tangent of half its angle over that of the scene's.
constexpr std::size_t kNumbers = 7;
using CameraNumbers = std::array<double, kNumbers>;

dmat3 turnOf(const CameraNumbers& numbers) {
    const dvec3 axis(numbers[3], numbers[4], numbers[5]);
    const double angle = glm::length(axis);
    return angle > 0 ? glm::mat3_cast(glm::angleAxis(angle, axis / angle)) : dmat3(1.0);
}

class CameraProblem {
public:
    CameraProblem(const std::vector<SeenSquare>& seen, const BoardLayout& board, const scene::Camera& camera, ivec2 size)
        : seen_(seen), size_(size), focalPx_(0.5 * size.y / std::tan(glm::radians(camera.fovYDegrees) / 2)) {
        for (const SeenSquare& one : seen)
            places_.push_back(placeInView(board.squares[one.index], camera, size));
        unit_ = -places_.front().z;
    }
    [[nodiscard]] double unitMetres() const { return unit_; }

    /// Of each square, how far right and down it is seen of where that camera sees it, pixels.
    [[nodiscard]] std::vector<double> misses(const CameraNumbers& numbers) const {
        const dmat3 back = glm::transpose(turnOf(numbers));
        const dvec3 eye = unit_ * dvec3(numbers[0], numbers[1], numbers[2]);
        const double focal = focalPx_ * std::exp(-numbers[6]);
        std::vector<double> misses;
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            const dvec3 place = back * (places_[i] - eye);
            const double depth = std::max(-place.z, 1e-6 * unit_);
            misses.push_back(seen_[i].seenPx.x - (0.5 * size_.x + focal * place.x / depth));
            misses.push_back(seen_[i].seenPx.y - (0.5 * size_.y - focal * place.y / depth));
        }
        return misses;
    }

private:
    const std::vector<SeenSquare>& seen_;
    std::vector<dvec3> places_;
    ivec2 size_;
    double focalPx_, unit_ = 1;
};

double squaresOf(const std::vector<double>& misses) {
    double sum = 0;
    for (const double miss : misses)
        sum += miss * miss;
    return sum;
}

/// The solution of a positive definite system, by elimination.
CameraNumbers solved(std::array<CameraNumbers, kNumbers> rows, CameraNumbers right) {
    for (std::size_t k = 0; k < kNumbers; ++k)
        for (std::size_t i = k + 1; i < kNumbers; ++i) {
            const double factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j < kNumbers; ++j)
                rows[i][j] -= factor * rows[k][j];
            right[i] -= factor * right[k];
        }
    for (std::size_t k = kNumbers; k-- > 0;) {
        for (std::size_t j = k + 1; j < kNumbers; ++j)
            right[k] -= rows[k][j] * right[j];
        right[k] /= rows[k][k];
    }
    return right;
}

CameraNumbers fittedNumbers(const CameraProblem& problem) {
    CameraNumbers numbers{};
    std::vector<double> misses = problem.misses(numbers);
    double damping = 1e-3;
    constexpr int kMostSteps = 100; // from any start that shows the squares, some ten are enough
    for (int step = 0; step < kMostSteps; ++step) {
        constexpr double kStep = 1e-6; // of differences that stand for derivatives
        std::array<std::vector<double>, kNumbers> slopes;
        for (std::size_t k = 0; k < kNumbers; ++k) {
            CameraNumbers moved = numbers;
            moved[k] += kStep;
            slopes[k] = problem.misses(moved);
            for (std::size_t i = 0; i < misses.size(); ++i)
                slopes[k][i] = (slopes[k][i] - misses[i]) / kStep;
        }
        std::array<CameraNumbers, kNumbers> normal{};
        CameraNumbers right{};
        for (std::size_t k = 0; k < kNumbers; ++k)
            for (std::size_t i = 0; i < misses.size(); ++i) {
                right[k] -= slopes[k][i] * misses[i];
                for (std::size_t j = 0; j < kNumbers; ++j)
                    normal[k][j] += slopes[k][i] * slopes[j][i];
            }
        for (std::size_t k = 0; k < kNumbers; ++k)
            normal[k][k] *= 1 + damping;
        const CameraNumbers by = solved(normal, right);
        CameraNumbers tried = numbers;
        for (std::size_t k = 0; k < kNumbers; ++k)
            tried[k] += by[k];
        const std::vector<double> left = problem.misses(tried);
        if (squaresOf(left) < squaresOf(misses)) {
            numbers = tried, misses = left, damping *= 0.2;
        } else {
            damping *= 5;
        }
    }
    return numbers;
}

} // namespace

std::optional<FittedCamera> fittedCamera(const std::vector<SeenSquare>& seen, const BoardLayout& board, const scene::Camera& camera, ivec2 size) {
    if (seen.size() < 5) return std::nullopt;
    const CameraProblem problem(seen, board, camera, size);
    const CameraNumbers numbers = fittedNumbers(problem);
    const std::vector<double> misses = problem.misses(numbers);
    const dmat3 worldFromView = glm::transpose(dmat3(scene::viewFromWorld(camera))), turn = turnOf(numbers);
    FittedCamera fit;
    fit.movedWorld = problem.unitMetres() * (worldFromView * dvec3(numbers[0], numbers[1], numbers[2]));
    fit.awayDegrees = glm::degrees(std::acos(std::clamp(turn[2].z, -1.0, 1.0)));
    fit.rolledDegrees = glm::degrees(numbers[5]);
    fit.fovYDegrees = glm::degrees(2 * std::atan(std::tan(glm::radians(camera.fovYDegrees) / 2) * std::exp(numbers[6])));
    for (std::size_t i = 0; i < misses.size(); i += 2)
        fit.worstPx = std::max(fit.worstPx, std::hypot(misses[i], misses[i + 1]));
    return fit;
}

bool isPlane(const std::vector<SeenSquare>& seen, const Placement& placed, ivec2 size) {
    // A turn in the picture leaves its axes at right angles, and other changes leave them level and upright.
    const double shearPx = std::abs(placed.perX.y + placed.perY.x) * 0.25 * std::max(size.x, size.y);
    return worstMissPx(seen, placed) < kLeastCornerPx && shearPx < kLeastCornerPx;
}

} // namespace shadowlab::foreign
