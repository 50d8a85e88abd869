// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/emitters.h"

#include <algorithm>

namespace shadowlab::radiosity {

namespace {

// Patches that shine are found by chance well enough where they are more than this share of all surfaces.
constexpr double kRare = 0.1;

} // namespace

Emitters::Emitters(const Room& room, const Sources& sources) : originWorld_(room.world().originWorld) {
    const std::vector<Patch>& all = room.allPatches();
    double power = 0, shiningArea = 0, area = 0;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        area += i < room.patches().size() ? all[i].area : 0; // loose sides, such as that of a ground, would make all else rare
        if (sources.emission[i] == dvec3(0) || !room.simple().cornersOfObject[room.faceOf(all[i]).object].empty()) continue;
        power += luminance(sources.emission[i]) * all[i].area;
        shiningArea += all[i].area;
        patches_.push_back({i, power, all[i].polygon, all[i].normal});
    }
    if (!(power > 0) || shiningArea > kRare * area) patches_.clear();
    densities_.resize(patches_.empty() ? 0 : all.size(), 0.0);
    double before = 0;
    for (Shining& one : patches_) {
        one.upTo /= power;
        densities_[one.patch] = (one.upTo - before) / all[one.patch].area;
        before = one.upTo;
    }
}

Emitters::Choice Emitters::choose(double which, const dvec2& where) const {
    const auto found = std::ranges::upper_bound(patches_, which, {}, &Shining::upTo);
    const Shining& one = found == patches_.end() ? patches_.back() : *found;
    const Place place = placeIn(one.polygon, where.x, where.y);
    const double area = glm::length(areaVector(one.polygon));
    // Where the map to the polygon stretches the unit square, points are fewer.
    const double stretched = one.polygon.count() == 3 ? area : one.polygon.count() == 4 ? place.weight : 0.5 * place.weight;
    return {one.patch, originWorld_ + place.point, one.normal, density(one.patch) * area / stretched};
}

} // namespace shadowlab::radiosity
