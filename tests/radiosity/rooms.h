// Rooms whose radiosity is known, for the tests of the solvers.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/equations/problem.h"

namespace shadowlab::radiosity::testing {

/// What a problem refers to and what it holds, together.
struct Room {
    ExchangeMatrix exchange;
    std::vector<double> areas;
    std::vector<dvec3> emission, reflectance;
    [[nodiscard]] Problem problem() const { return {exchange, areas, emission, reflectance}; }
    [[nodiscard]] std::size_t size() const { return areas.size(); }
};

/// Parallel equal squares at a distance of one side (Howell's catalogue, C-11, with X = Y = 1), worked out in full digits.
inline double oppositeInCube() {
    const long double root = std::sqrt(2.0L);
    return static_cast<double>(2 / glm::pi<long double>() *
                               (std::log(std::sqrt(4.0L / 3)) + 2 * root * std::atan(1 / root) - 2 * std::atan(1.0L)));
}

/// Squares at right angles with a common edge (C-14, with H = W = 1).
inline double adjacentInCube() {
    const long double root = std::sqrt(2.0L), inLogarithm = 4.0L / 3 * (3.0L / 4) * (3.0L / 4);
    return static_cast<double>(1 / glm::pi<long double>() *
                               (2 * std::atan(1.0L) - root * std::atan(1 / root) + 0.25L * std::log(inLogarithm)));
}

/// A unit cube with one patch for each face: floor, ceiling, four walls. Grey; the floor emits 1 W/m^2.
inline Room cube(double floor, double wall, double ceiling) {
    Room room{ExchangeMatrix(6), std::vector(6, 1.0), std::vector(6, dvec3(0)), std::vector(6, dvec3(wall))};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < i; ++j)
            room.exchange.set(i, j, i / 2 == j / 2 ? oppositeInCube() : adjacentInCube()); // 0-1, 2-3, 4-5 are opposite
    room.emission[0] = dvec3(1);
    room.reflectance[0] = dvec3(floor);
    room.reflectance[1] = dvec3(ceiling);
    return room;
}

/// Patches inside a sphere, which they cover: F_ij = A_j / sum A for every pair, and for i = j too.
inline Room sphereInside(std::vector<double> areas, std::vector<dvec3> emission, std::vector<dvec3> reflectance) {
    double total = 0;
    for (const double area : areas)
        total += area;
    ExchangeMatrix exchange(areas.size());
    for (std::size_t i = 0; i < areas.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            exchange.set(i, j, areas[i] * areas[j] / total);
    return {std::move(exchange), std::move(areas), std::move(emission), std::move(reflectance)};
}

/// A unit cube with n x n patches for each face. Form factors are those of two points, the centres, scaled until the room is
/// closed: far from exact where patches touch, but their matrix has the size and the spectrum of a room's.
inline Room subdividedCube(std::size_t n) {
    std::vector<dvec3> centres, normals;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.0, 1.0})
            for (std::size_t u = 0; u < n; ++u)
                for (std::size_t v = 0; v < n; ++v) {
                    dvec3 centre, normal(0);
                    centre[axis] = side;
                    centre[(axis + 1) % 3] = (static_cast<double>(u) + 0.5) / static_cast<double>(n);
                    centre[(axis + 2) % 3] = (static_cast<double>(v) + 0.5) / static_cast<double>(n);
                    normal[axis] = side == 0 ? 1 : -1;
                    centres.push_back(centre);
                    normals.push_back(normal);
                }
    const std::size_t size = centres.size();
    const double area = 1.0 / static_cast<double>(n * n);
    ExchangeMatrix raw(size);
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const dvec3 between = centres[j] - centres[i];
            const double squared = glm::dot(between, between);
            const double cosines = glm::dot(normals[i], between) * glm::dot(normals[j], -between) / squared;
            raw.set(i, j, std::max(cosines, 0.0) * area * area / (glm::pi<double>() * squared));
        }
    std::vector<double> areas(size, area);
    ScaledExchange scaled = scaledToClosure(std::move(raw), areas, Closure::closedRoom);
    Room room{std::move(scaled.exchange), std::move(areas), std::vector(size, dvec3(0)), std::vector(size, dvec3(0.5))};
    for (std::size_t i = 0; i < n * n; ++i)
        room.emission[i] = dvec3(1);
    return room;
}

/// Any room: size, areas, who sees whom, closed or open, colours. Reflectances come as near to 1 as 1e-8. Of a room that
/// light would not leave, the reflectances are taken down a little.
inline Room randomRoom(std::uint64_t seed) {
    std::mt19937_64 numbers(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const std::size_t size = 1 + numbers() % 24;
    std::vector<double> areas(size);
    const double spread = 3 * unit(numbers);
    for (double& area : areas)
        area = std::pow(10, spread * (unit(numbers) - 0.5));
    ExchangeMatrix raw(size);
    const double density = 0.2 + 0.8 * unit(numbers);
    const bool isConcave = unit(numbers) < 0.5; // then patches see themselves
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            if (unit(numbers) < density && (i != j || isConcave)) raw.set(i, j, areas[i] * areas[j] * unit(numbers));
    const bool isOpen = unit(numbers) < 0.3;
    ScaledExchange scaled = scaledToClosure(raw, areas, Closure::closedRoom);
    if (isOpen || !scaled.isClosed) scaled = scaledToClosure(std::move(raw), areas, Closure::openScene);
    Room room{std::move(scaled.exchange), std::move(areas), {}, {}};
    const double nearOne = unit(numbers);
    for (std::size_t i = 0; i < size; ++i) {
        dvec3 emission(0), reflectance(0);
        for (int c = 0; c < 3; ++c) {
            if (unit(numbers) < 0.4) emission[c] = std::pow(10, 6 * unit(numbers) - 3);
            if (const double kind = unit(numbers); kind < nearOne)
                reflectance[c] = 1 - std::pow(10, -8 * unit(numbers));
            else if (kind < 0.95)
                reflectance[c] = unit(numbers);
        }
        room.emission.push_back(emission);
        room.reflectance.push_back(reflectance);
    }
    for (int i = 0; refusal(room.problem()) && i < 200; ++i) // some row sums are above 1, though by less than 1e-6
        for (dvec3& value : room.reflectance)
            value *= 1 - 1e-8;
    return room;
}

using Longs = std::array<long double, 3>;

/// The radiosity by elimination in long double, 11 bits more than double has. Without pivots: no row of I - rho F sums to less
/// than 1 - q > 0, and so it stays.
inline std::vector<Longs> eliminated(const Problem& problem) {
    const std::size_t size = problem.areas.size();
    std::vector<Longs> radiosity(size);
    for (int c = 0; c < 3; ++c) {
        std::vector<std::vector<long double>> rows(size, std::vector<long double>(size + 1));
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t j = 0; j < size; ++j)
                rows[i][j] = (i == j ? 1.0L : 0.0L) - static_cast<long double>(problem.reflectance[i][c]) *
                                                          problem.exchange(i, j) / problem.areas[i];
            rows[i][size] = problem.emission[i][c];
        }
        for (std::size_t k = 0; k < size; ++k)
            for (std::size_t i = k + 1; i < size; ++i) {
                const long double share = rows[i][k] / rows[k][k];
                for (std::size_t j = k; j <= size; ++j)
                    rows[i][j] -= share * rows[k][j];
            }
        for (std::size_t i = size; i-- > 0;) {
            long double value = rows[i][size];
            for (std::size_t j = i + 1; j < size; ++j)
                value -= rows[i][j] * radiosity[j][c];
            radiosity[i][c] = value / rows[i][i];
        }
    }
    return radiosity;
}

} // namespace shadowlab::radiosity::testing
