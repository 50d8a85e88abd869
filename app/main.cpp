// The program: parse, dispatch to a subcommand, and the only place where errors become messages and exit statuses.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "app/cli/command_line.h"
#include "app/cli/messages.h"
#include "app/context/mesa.h"
#include "app/context/signals.h"
#include "app/student/plugins.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/temporaries.h"

namespace {

int fail(shadowlab::ExitStatus status, const std::string& message) {
    shadowlab::cli::complain(message);
    return static_cast<int>(status);
}

bool hasEnded = false;

/// Nothing of this program calls exit(). What does would else leave with whatever status it likes, and without a picture.
void onExit() {
    if (hasEnded) return;
    fail(shadowlab::ExitStatus::bug, std::string(shadowlab::student::kEndedByPlugin) + "; try without it");
    shadowlab::image::removeTemporariesNow();
    ::_exit(static_cast<int>(shadowlab::ExitStatus::bug));
}

int run(int argc, char** argv) {
    using shadowlab::ExitStatus;
    try {
        return shadowlab::cli::run(argc, argv);
    } catch (const shadowlab::context::Interrupted& interrupted) {
        return interrupted.exitStatus;
    } catch (const shadowlab::Error& error) {
        return fail(error.status(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitStatus::overLimit,
                    "out of memory; use a smaller scene or picture (every file is whole, or as it was)");
    } catch (const std::exception& error) {
        const bool own = shadowlab::student::loadedPlugins().empty();
        return fail(ExitStatus::bug,
                    std::string("internal error: ") + error.what() +
                        (own ? "; this is a fault of the program, please report it with the command line"
                             : "; this is a fault of the program or of a plug-in, try without it"));
    }
}

} // namespace

int main(int argc, char** argv) {
    shadowlab::context::spareAddresses();
    shadowlab::cli::keepStandardDescriptors();
    shadowlab::context::installSignalHandlers();
    std::atexit(onExit);
    const int status = run(argc, argv);
    hasEnded = true;
    return status;
}
