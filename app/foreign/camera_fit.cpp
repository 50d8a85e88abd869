// SPDX-License-Identifier: MIT
#include "app/foreign/camera_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <glm/gtc/quaternion.hpp>

namespace shadowlab::foreign {

namespace {

/// Of the fitted camera in the view space of the scene's: place (in units of the squares' distance), turn (a vector along its axis, radians), and the
/// logarithm of the tangent of half its angle over that of the scene's.
constexpr int kNumbers = 7;
using CameraNumbers = Eigen::Vector<double, kNumbers>;

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
    [[nodiscard]] Eigen::VectorXd misses(const CameraNumbers& numbers) const {
        const dmat3 back = glm::transpose(turnOf(numbers));
        const dvec3 eye = unit_ * dvec3(numbers[0], numbers[1], numbers[2]);
        const double focal = focalPx_ * std::exp(-numbers[6]);
        Eigen::VectorXd misses(2 * std::ssize(seen_));
        for (std::size_t i = 0; i < seen_.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(2 * i);
            const dvec3 place = back * (places_[i] - eye);
            const double depth = std::max(-place.z, 1e-6 * unit_);
            misses[row] = seen_[i].seenPx.x - (0.5 * size_.x + focal * place.x / depth);
            misses[row + 1] = seen_[i].seenPx.y - (0.5 * size_.y - focal * place.y / depth);
        }
        return misses;
    }

private:
    const std::vector<SeenSquare>& seen_;
    std::vector<dvec3> places_;
    ivec2 size_;
    double focalPx_, unit_ = 1;
};

CameraNumbers fittedNumbers(const CameraProblem& problem) {
    CameraNumbers numbers = CameraNumbers::Zero();
    Eigen::VectorXd misses = problem.misses(numbers);
    double damping = 1e-3;
    constexpr int kMostSteps = 100; // from any start that shows the squares, some ten are enough
    for (int step = 0; step < kMostSteps; ++step) {
        constexpr double kStep = 1e-6; // of differences that stand for derivatives
        Eigen::Matrix<double, Eigen::Dynamic, kNumbers> slopes(misses.size(), kNumbers);
        for (int k = 0; k < kNumbers; ++k) {
            CameraNumbers moved = numbers;
            moved[k] += kStep;
            slopes.col(k) = (problem.misses(moved) - misses) / kStep;
        }
        Eigen::Matrix<double, kNumbers, kNumbers> normal = slopes.transpose() * slopes;
        normal.diagonal() *= 1 + damping;
        const CameraNumbers tried = numbers - normal.ldlt().solve(slopes.transpose() * misses);
        const Eigen::VectorXd left = problem.misses(tried);
        const bool isBetter = left.squaredNorm() < misses.squaredNorm();
        if (isBetter) numbers = tried, misses = left;
        damping *= isBetter ? 0.2 : 5;
    }
    return numbers;
}

} // namespace

std::optional<FittedCamera> fittedCamera(const std::vector<SeenSquare>& seen, const BoardLayout& board, const scene::Camera& camera, ivec2 size) {
    constexpr std::size_t kFewest = 5;
    if (seen.size() < kFewest) return std::nullopt;
    const CameraProblem problem(seen, board, camera, size);
    const CameraNumbers numbers = fittedNumbers(problem);
    const Eigen::VectorXd misses = problem.misses(numbers);
    const dmat3 worldFromView = glm::transpose(dmat3(scene::viewFromWorld(camera))), turn = turnOf(numbers);
    FittedCamera fit;
    fit.movedWorld = problem.unitMetres() * (worldFromView * dvec3(numbers[0], numbers[1], numbers[2]));
    fit.awayDegrees = glm::degrees(std::acos(std::clamp(turn[2].z, -1.0, 1.0)));
    fit.rolledDegrees = glm::degrees(numbers[5]);
    fit.fovYDegrees = glm::degrees(2 * std::atan(std::tan(glm::radians(camera.fovYDegrees) / 2) * std::exp(numbers[6])));
    for (Eigen::Index i = 0; i < misses.size(); i += 2)
        fit.worstPx = std::max(fit.worstPx, std::hypot(misses[i], misses[i + 1]));
    return fit;
}

bool isPlane(const std::vector<SeenSquare>& seen, const Placement& placed, ivec2 size) {
    // A turn in the picture leaves its axes at right angles, and other changes leave them level and upright.
    const double shearPx = std::abs(placed.perX.y + placed.perY.x) * 0.25 * std::max(size.x, size.y);
    return worstMissPx(seen, placed) < kLeastCornerPx && shearPx < kLeastCornerPx;
}

} // namespace shadowlab::foreign
