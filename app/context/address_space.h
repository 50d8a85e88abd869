// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::context {

/// Where addresses are limited (`ulimit -v`): the C library keeps 64 MB of them, unused, for each thread that asks for memory, and
/// Mesa crashes where it gets none. One store of memory for all threads then, which is slower, but the limit is left to what is
/// used. Called in main, before there are threads.
void spareAddresses();

} // namespace shadowlab::context
