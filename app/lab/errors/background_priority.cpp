// SPDX-License-Identifier: MIT
#include "app/lab/errors/background_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace shadowlab::lab {

void yieldToDrawing() {
#ifdef __linux__
    setpriority(PRIO_PROCESS, 0, kBackgroundNice); // on Linux 0 is the calling thread
#endif
}

} // namespace shadowlab::lab
