// What the points of a group say together: which of them are worth having, how cost and error grow, and what exactness costs.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/report/results.h"

namespace shadowlab::report {

/// Marks the Pareto front: the points than which no other is both cheaper (median of frames) and less wrong. The yardstick, and
/// points that serve a part of the pixels only, are neither on it nor compared with others.
void markFront(Group& group);

/// Of every sweep whose parameter is a number: how cost and error grow along it.
std::vector<Growth> growthOf(const Group& group);

/// The cheapest point without a wrong pixel beside the cheapest that has some, and, where it costs more than twice as much, which
/// part of it takes the time.
ExactAgainstInexact exactnessOf(const Group& group);

/// All three.
void analyse(Group& group);

} // namespace shadowlab::report
