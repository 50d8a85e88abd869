// A scene of eight lights and two hundred casters, of which two lights and twenty casters matter for the picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace shadowlab::speed {

/// The text of a scene file. The eye looks at twenty casters in the middle of a wide floor, which a sun and a lamp light. Of the
/// other casters the shadows fall beside the picture; of the other lights four are spots that shine elsewhere, one is a panel
/// that is turned away, and one is beneath the floor and shines down. `whole` = false: without any of these. What is seen is the same.
std::string crowdedScene(bool whole);

} // namespace shadowlab::speed
