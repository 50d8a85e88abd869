// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/dielectric_stack.h"

#include <algorithm>

namespace shadowlab::ray_tracing {

namespace {

constexpr double kEmptySpace = 1.0; // index of refraction of vacuum, and of air to three digits

bool isSame(const Medium& a, const Medium& b) { return a.solid == b.solid; }

} // namespace

std::vector<Medium>::const_iterator DielectricStack::top() const {
    auto best = inside_.end();
    for (auto medium = inside_.begin(); medium != inside_.end(); ++medium)
        if (best == inside_.end() || medium->priority >= best->priority) best = medium;
    return best;
}

double DielectricStack::ior() const { return inside_.empty() ? kEmptySpace : top()->ior; }

bool DielectricStack::holds(const Medium& medium) const {
    return std::ranges::any_of(inside_, [&](const Medium& other) { return isSame(other, medium); });
}

Crossing DielectricStack::crossing(const Medium& medium, bool entering) const {
    // A surface is left as it would be entered: with the medium at hand, though nobody has seen the ray go in.
    DielectricStack before = *this, after = *this;
    if (entering)
        after.cross(medium, true);
    else if (holds(medium))
        after.cross(medium, false);
    else
        before.cross(medium, true);
    const DielectricStack& within = entering ? after : before;
    return {before.ior(), after.ior(), isSame(*within.top(), medium)};
}

void DielectricStack::cross(const Medium& medium, bool entering) {
    if (entering) {
        inside_.push_back(medium);
        return;
    }
    const auto last =
        std::find_if(inside_.rbegin(), inside_.rend(), [&](const Medium& other) { return isSame(other, medium); });
    if (last != inside_.rend()) inside_.erase(std::next(last).base());
}

} // namespace shadowlab::ray_tracing
