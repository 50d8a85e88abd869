// The strict first reading of an MTL file: the numbers used here, checked, clamped and completed, in the form tinyobjloader then
// reads, and beside them what it does not pass on. Of all other statements a note tells.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/obj/mtl_optics.h"

namespace shadowlab::scene {

struct CleanMtl {
    std::string text;
    /// Of the newmtl statements, also those that repeat a name: tinyobjloader keeps them all. The text has their numbers in place of
    /// the names, which tinyobjloader takes to the end of the line (2.0.0rc10) or up to the first blank (rc13).
    std::vector<std::string> names;
    std::map<std::string, MtlStatements> more; ///< of each material, by its name
};

/// Throws Error "FILE:LINE: ..." where a value is no finite number; values out of range are clamped with one note,
/// and each kind of statement that is ignored gets one.
/// A material without Kd gets the default grey.
CleanMtl cleanMtl(std::string_view text, const std::filesystem::path& file, const Limits& limits,
                  std::vector<std::string>& notes);

} // namespace shadowlab::scene
