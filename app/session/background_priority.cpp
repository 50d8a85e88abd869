// SPDX-License-Identifier: MIT
#include "app/session/background_priority.h"

#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#endif

namespace shadowlab::session {

void yieldToAllOthers() {
#ifdef __linux__
    const sched_param none{};
    pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);
#endif
}

} // namespace shadowlab::session
