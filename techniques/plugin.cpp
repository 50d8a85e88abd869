// SPDX-License-Identifier: MIT
#include "techniques/plugin.h"

#include "techniques/plugin_contract.h"

namespace shadowlab {

std::string_view contractOfProgram() { return SHADOWLAB_PLUGIN_CONTRACT; }

} // namespace shadowlab
