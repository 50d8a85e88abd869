// What libFuzzer calls, once for each string of bytes that it makes up.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    shadowlab::fuzz::feed({reinterpret_cast<const char*>(data), size});
    return 0;
}
