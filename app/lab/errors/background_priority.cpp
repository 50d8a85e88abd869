// SPDX-License-Identifier: MIT
#include "app/lab/errors/background_priority.h"

#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#endif

namespace shadowlab::lab {

void yieldToAllOthers() {
#ifdef __linux__
    const sched_param none{};
    pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);
#endif
}

} // namespace shadowlab::lab
