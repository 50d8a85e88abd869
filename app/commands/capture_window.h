// `shadowlab capture --ui`: the window as it looks, without a window.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/commands/capture_options.h"

namespace shadowlab::commands {

/// Throws Error.
int captureWindow(const CaptureOptions& options);

} // namespace shadowlab::commands
