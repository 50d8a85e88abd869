// What radiosity has to say of a frame in words and numbers.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/display/stages.h"

namespace shadowlab::radiosity {

/// Counters and notes: how many patches, how good the form factors are and what scaling changed, how far solving has come, where
/// the power goes, and what of the materials is left out.
void tell(const Showing& showing);

} // namespace shadowlab::radiosity
