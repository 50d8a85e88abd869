// Which settings of its techniques an explorable slide is drawn with: its own, and for each parameter that can be tried its other values,
// one parameter at a time.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/course/explore/explored_slide.h"
#include "techniques/foundation/params/param.h"

namespace shadowlab::course {

/// A parameter with its values, the slide's own among them.
struct Knob {
    std::string id;    ///< "shadow-map.resolution"
    std::string label; ///< "Map resolution, texels"
    std::vector<std::string> values; ///< as --set takes them
    std::vector<std::string> labels; ///< the same in words
    int start = 0;     ///< index of the slide's own value
};

struct ExploredVariants {
    std::vector<Knob> knobs;
    std::vector<std::vector<int>> combinations;     ///< of values, one for each knob; the first is the slide's own
    std::vector<std::vector<lab::PaneState>> drawn; ///< of each pane: those that differ
    std::vector<std::vector<int>> places;           ///< of each pane and combination: which of `drawn` it is
};

/// A value as a button says it: choices in words, numbers as they are, since the unit stands beside the name.
std::string valueWords(const std::string& value, const params::Param& param);

ExploredVariants variantsOf(const std::vector<ExploredPane>& panes, const Explore& explore);

} // namespace shadowlab::course
