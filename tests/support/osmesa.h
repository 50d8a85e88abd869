// OSMesa is a backend of the first rank: its tests fail where the distribution has it and it does not work. Mesa ended it in 25.1, so
// where the distribution has none they are skipped, and say so.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/context/backends.h"
#include "app/context/packages.h"

namespace shadowlab::testing {

inline constexpr const char* kNoOsmesa = "this distribution's Mesa has no OSMesa: it ended in 25.1";

inline bool mayLackOsmesa() { return !context::isOsmesaHere() && !context::hasOsmesaPackage(); }

} // namespace shadowlab::testing
