// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/tree/dielectric_stack.h"

namespace shadowlab::ray_tracing {

namespace {

constexpr double kEmptySpace = 1.0; // index of refraction of vacuum, and of air to three digits

} // namespace

DielectricStack::Place DielectricStack::last(const Medium& medium) const {
    Place found = inside_.end();
    for (Place place = inside_.begin(); place != inside_.end(); ++place)
        if (place->solid == medium.solid) found = place;
    return found;
}

DielectricStack::Place DielectricStack::top(Place leftOut) const {
    Place best = inside_.end();
    for (Place place = inside_.begin(); place != inside_.end(); ++place)
        if (place != leftOut && (best == inside_.end() || place->priority >= best->priority)) best = place;
    return best;
}

double DielectricStack::ior() const {
    const Place place = top(inside_.end());
    return place == inside_.end() ? kEmptySpace : place->ior;
}

bool DielectricStack::holds(const Medium& medium) const { return last(medium) != inside_.end(); }

Crossing DielectricStack::crossing(const Medium& medium, bool entering) const {
    // The medium without that solid; and does the solid have priority over it? One that is not in the list counts as entered
    // last.
    const Place held = entering ? inside_.end() : last(medium);
    const Place other = top(held);
    const double otherIor = other == inside_.end() ? kEmptySpace : other->ior;
    const bool wins = other == inside_.end() || medium.priority > other->priority ||
                      (medium.priority == other->priority && other < held);
    if (!wins) return {otherIor, otherIor, false};
    return entering ? Crossing{otherIor, medium.ior, true} : Crossing{medium.ior, otherIor, true};
}

void DielectricStack::cross(const Medium& medium, bool entering) {
    if (entering)
        inside_.push_back(medium);
    else if (const Place held = last(medium); held != inside_.end())
        inside_.erase(held);
}

} // namespace shadowlab::ray_tracing
