// SPDX-License-Identifier: MIT
#include "app/context/address_space.h"

#include <malloc.h>
#include <sys/resource.h>

namespace shadowlab::context {

void spareAddresses() {
    rlimit addresses{};
    if (::getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY) ::mallopt(M_ARENA_MAX, 1);
}

} // namespace shadowlab::context
