// Rows of a matrix shared out over the threads, in pieces that depend on the size of the matrix alone.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>

#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::radiosity {

/// Calls work(0) ... work(size - 1), one row each, on several threads where that is worth it.
inline void forRows(std::size_t size, const std::function<void(std::size_t)>& work) {
    // Some 50 microseconds of work each, as much as it takes to start a thread; a small matrix is one piece, and no thread.
    constexpr std::size_t kNumbersInPiece = 1 << 16;
    const std::size_t rows = std::max<std::size_t>(1, kNumbersInPiece / std::max<std::size_t>(1, size));
    const auto workOn = [&](std::size_t piece) {
        for (std::size_t i = piece * rows; i < std::min(size, (piece + 1) * rows); ++i)
            work(i);
    };
    if (size <= rows)
        workOn(0); // nothing to share out, not even the question how many threads there are
    else
        trace::parallelFor((size + rows - 1) / rows, workOn);
}

} // namespace shadowlab::radiosity
