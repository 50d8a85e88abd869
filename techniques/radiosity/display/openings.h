// Where light from outside comes in: windows and doors, found by rays.
//
// In a room with a window few of the rays that leave a point in all directions go out, and what they bring is then noise, as with small
// bright patches (gather_guide.h). So a gather also sends rays to points of the openings, and weighs both kinds in the same way. An opening is known
// as cells of a box around the scene, those through which rays from the patches have gone out. A ray that goes out through another cell
// counts in full, so that nothing is lost where none has been found.
// Under the open sky rays in all directions find it well enough, and there are no openings.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "techniques/radiosity/room/room.h"

namespace shadowlab::radiosity {

class Openings {
public:
    Openings() = default;
    explicit Openings(const Room& room);
    [[nodiscard]] bool isEmpty() const { return open_.empty(); }
    /// Does light from outside, of that radiance, make up a good part of the irradiance (W/m^2) of the room's patches? Else rays to openings
    /// would be wasted.
    [[nodiscard]] bool bringMuch(const dvec3& outside, std::span<const Patch> patches, std::span<const dvec3> irradiance) const;
    /// Only from places within the box openings can be asked for.
    [[nodiscard]] bool surround(const dvec3& positionWorld) const;

    /// A point of an opening.
    struct Choice {
        dvec3 positionWorld{0.0}, inward{0.0}; ///< inward: unit
    };
    /// `which` and `where`: of the unit interval and the unit square, evenly distributed.
    [[nodiscard]] Choice choose(double which, const dvec2& where) const;
    /// The density with which points of openings are chosen, 1/m^2.
    [[nodiscard]] double density() const { return 1 / area_; }

    /// How a ray from inside goes out through an opening.
    struct Exit {
        double distance = 0, cosine = 0; ///< metres; of the angle with the box's normal
    };
    /// Nothing: it goes out elsewhere.
    [[nodiscard]] std::optional<Exit> exit(const dvec3& fromWorld, const dvec3& direction) const;

private:
    struct Crossing {
        double distance = 0;
        int axis = 0;
        std::size_t cell = 0;
    };
    [[nodiscard]] Crossing crossing(const dvec3& fromWorld, const dvec3& direction) const;
    void open(const Room& room);
    void openAround(std::size_t cell);

    dvec3 lower_{0.0}, upper_{0.0}; ///< of the box, world space
    std::vector<std::uint8_t> isOpen_; ///< of each cell
    std::vector<std::uint32_t> open_;  ///< the cells that are
    std::vector<double> upTo_;         ///< of each of those, the share of the area that it and those before it have
    double area_ = 0;                  ///< of all of them, m^2
    /// Of each of the room's patches, the share of its view that is no surface; kOutside: it lies outside.
    std::vector<double> viewInside_;
    static constexpr double kOutside = 1;
};

} // namespace shadowlab::radiosity
