// `shadowlab capture --ui`: the window as it looks, without a window.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/cli/capture_options.h"

namespace shadowlab::cli {

/// Throws Error.
int captureWindow(const CaptureOptions& options);

} // namespace shadowlab::cli
