// Xlib calls a handler when its connection breaks, and ends the program should that return. So what has to be done is
// done there: remove temporaries, say why, leave. Destructors would talk to the display that is gone.
// SPDX-License-Identifier: MIT
#include "app/context/display_loss.h"

#include <unistd.h>

#include <cstring>

#include "app/context/library.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/temporaries.h"

namespace shadowlab::context {

namespace {

constexpr const char* kMessage = "shadowlab: no graphics context any more: the X server has closed the connection to "
                                 "the display; start the program again in a desktop session that runs\n";

int told = STDERR_FILENO;

using IoErrorHandler = int (*)(void* display);

int onDisplayGone(void*) {
    image::removeTemporariesNow();
    if (::write(told, kMessage, std::strlen(kMessage)) < 0) {
        // Standard error is gone, too; the exit status still tells the reason.
    }
    ::_exit(static_cast<int>(ExitStatus::noContext));
}

} // namespace

void tellLossOfDisplayOn(int descriptor) { told = descriptor; }

void endWhenDisplayIsGone() {
    static const Library xlib{"libX11.so.6"};
    IoErrorHandler (*setHandler)(IoErrorHandler) = nullptr;
    if (xlib.find(setHandler, "XSetIOErrorHandler")) setHandler(onDisplayGone);
}

} // namespace shadowlab::context
