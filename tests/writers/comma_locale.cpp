// A library to be loaded before all others (LD_PRELOAD): what a plug-in or a library may do to a program, it takes over
// the locale of the environment for C and for C++, before anything else runs.
// SPDX-License-Identifier: MIT
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <locale>

namespace {

__attribute__((constructor)) void takeOver() {
    std::locale::global(std::locale("")); // calls setlocale() for C, too
    if (*std::localeconv()->decimal_point == ',') return;
    std::fputs("comma_locale: the locale of the environment has no decimal comma\n", stderr);
    std::abort();
}

} // namespace
