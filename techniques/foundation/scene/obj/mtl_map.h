// A statement of an MTL file that lays an image on surfaces (map_Kd, map_d): options and the file's name.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"

namespace shadowlab::scene {

struct MtlMap {
    std::string file;  ///< as it stands there; it may hold blanks
    std::size_t fileAt = 0; ///< bytes into the statement
    std::string place; ///< "FILE:LINE"
    ImagePlacement placement;
    double base = 0.0, gain = 1.0;                                                     ///< -mm
    MaskChoice::Channel channel = MaskChoice::Channel::alphaOrBrightness;              ///< -imfchan, of a mask
    std::vector<std::string> ignored;                                                  ///< options that change the look, and are not supported

    [[nodiscard]] bool looksLike(const MtlMap& other) const {
        return file == other.file && placement == other.placement && base == other.base && gain == other.gain && channel == other.channel;
    }
};

/// Options stand before the name, or, as some programs write them, after it. -s, -o, -clamp, -mm and -imfchan are kept; -bm is about
/// relief and says nothing here.
MtlMap parseMtlMap(std::string_view statement);

} // namespace shadowlab::scene
