// What `judge` has found of a foreign picture, as text and as JSON.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "app/foreign/calibration_reading.h"
#include "app/foreign/judged_picture.h"

namespace shadowlab::cli {

/// Names of files are empty where there is none.
struct JudgeReport {
    std::string picture, reference, calibrationFile;
    std::string scene, light;
    ivec2 size{0};
    std::optional<foreign::Calibration> calibration;
    std::optional<foreign::JudgedPicture> judged; ///< none: the calibration is wrong
    std::string errorPicture, visibilityPicture, section; ///< written files
    std::string sectionCaption; ///< what the picture shows at the section's pixel; empty: there is no section
    std::string sectionRemark;                            ///< why there is no section, where one was asked for
};

std::string judgeJson(const JudgeReport& report);
/// `columns`: of the terminal that it has to fit; none: of a pipe.
std::string judgeText(const JudgeReport& report, std::optional<std::size_t> columns);

} // namespace shadowlab::cli
