// Points sorted into boxes, each object's for themselves: what lies near a place?
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "techniques/foundation/trace/area/shaft.h"

namespace shadowlab::radiosity {

class PointGrid {
public:
    /// The width of a box, metres, of every object.
    explicit PointGrid(std::vector<double> widths) : widths_(std::move(widths)) {}

    void add(std::uint32_t object, const dvec3& positionCentred, std::uint32_t number) {
        const auto place = placeOf(object, positionCentred);
        boxes_[{object, place[0], place[1], place[2]}].push_back(number);
    }

    /// Calls visit(number) for all points of that object in `box`, and some beside it.
    template <typename Visit>
    void near(std::uint32_t object, const trace::CentredBox& box, const Visit& visit) const {
        const auto lower = placeOf(object, box.lower), upper = placeOf(object, box.upper);
        for (std::int64_t x = lower[0]; x <= upper[0]; ++x)
            for (std::int64_t y = lower[1]; y <= upper[1]; ++y)
                for (std::int64_t z = lower[2]; z <= upper[2]; ++z)
                    if (const auto found = boxes_.find({object, x, y, z}); found != boxes_.end())
                        for (const std::uint32_t number : found->second)
                            visit(number);
    }

private:
    [[nodiscard]] std::array<std::int64_t, 3> placeOf(std::uint32_t object, const dvec3& positionCentred) const {
        const dvec3 place = glm::floor(positionCentred / widths_[object]);
        return {static_cast<std::int64_t>(place.x), static_cast<std::int64_t>(place.y),
                static_cast<std::int64_t>(place.z)};
    }

    std::vector<double> widths_;
    std::map<std::array<std::int64_t, 4>, std::vector<std::uint32_t>> boxes_;
};

} // namespace shadowlab::radiosity
