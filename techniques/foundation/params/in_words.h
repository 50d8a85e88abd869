// Values of parameters as people read them.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/foundation/params/param.h"

namespace shadowlab::params {

/// Of a value as it is written: "on", "percentage-closer filtering", "2048 texels", "1 map".
std::string inWords(const std::string& value, const Param& param);

} // namespace shadowlab::params
