// What was measured, as a table to read or as JSON.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/report/measurement.h"

namespace shadowlab::cli {

/// What all results have in common.
struct Measured {
    std::string scene, light, backend, renderer;
    ivec2 size{0};
    int frames = 1;
    double truthMs = 0, coverageMs = 0;
    std::vector<report::TechniqueErrors> results;
};

/// One JSON object; a number that does not exist (a distance without boundaries, the PSNR of equal pictures) is null.
std::string measureJson(const Measured& measured);

/// Tables for people: what the truth is, errors, pictures, times. `columns`: of the terminal that they have to fit; none: of a pipe.
std::string measureTable(const Measured& measured, std::optional<std::size_t> columns);

} // namespace shadowlab::cli
