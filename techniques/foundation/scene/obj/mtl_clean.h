// The strict first reading of an MTL file: the statements used here, checked, clamped and completed, in the form
// tinyobjloader then reads. All other statements (other maps, PBR extensions, illum ...) are dropped.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

struct CleanMtl {
    std::string text;
    /// Of the newmtl statements, also those that repeat a name: tinyobjloader keeps them all. The text has their numbers in place of
    /// the names, which tinyobjloader takes to the end of the line (2.0.0rc10) or up to the first blank (rc13).
    std::vector<std::string> names;
    std::map<std::string, std::string> alphaMapPlaces; ///< of a material that names one: "FILE:LINE" of its map_d
};

/// Throws Error "FILE:LINE: ..." where a value is no finite number; values out of range are clamped with one note,
/// and each kind of statement that would have changed the look but is ignored gets one.
/// A material without Kd gets the default grey.
CleanMtl cleanMtl(std::string_view text, const std::filesystem::path& file, const Limits& limits,
                  std::vector<std::string>& notes);

} // namespace shadowlab::scene
