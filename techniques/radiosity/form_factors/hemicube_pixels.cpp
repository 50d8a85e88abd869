// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/hemicube_pixels.h"

#include "techniques/radiosity/form_factors/point_form_factor.h"

namespace shadowlab::radiosity {

std::vector<double> deltaFormFactors(int side) {
    std::vector<double> factors;
    const ivec2 picture = hemicubePicture(side);
    factors.reserve(static_cast<std::size_t>(picture.x) * static_cast<std::size_t>(picture.y));
    const double step = 2.0 / side; // of hemicube space, from pixel to pixel
    for (const HemicubeFace& face : kHemicubeFaces) {
        const int rows = face.rows * side / 2;
        const double firstUp = 1 - rows * step; // -1 for the upper face, 0 for the sides
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < side; ++column) {
                const auto corner = [&](int right, int up) {
                    return face.forward + ((column + right) * step - 1) * face.right() +
                           (firstUp + (row + up) * step) * face.up;
                };
                // Counter-clockwise seen from the origin, which sees its front.
                const Polygon pixel{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                factors.push_back(pointFormFactor(dvec3(0), dvec3(0, 0, 1), pixel));
            }
    }
    return factors;
}

} // namespace shadowlab::radiosity
