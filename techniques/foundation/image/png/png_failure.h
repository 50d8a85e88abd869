// The error handling that encoding and decoding share.
//
// libpng reports errors by longjmp, which must not jump over C++ objects with destructors. So each direction has
// functions that call setjmp and own nothing: everything with a destructor lives in their callers.
// SPDX-License-Identifier: MIT
#pragma once
#include <png.h>

#include <cstdio>

namespace shadowlab::image {

/// The last message of libpng; a plain array, since it is written just before a longjmp.
struct PngFailure {
    char message[200] = "";
};

[[noreturn]] inline void onPngError(png_structp png, png_const_charp message) {
    auto* failure = static_cast<PngFailure*>(png_get_error_ptr(png));
    std::snprintf(failure->message, sizeof failure->message, "%s", message);
    png_longjmp(png, 1);
}
inline void onPngWarning(png_structp, png_const_charp) {} // an odd colour profile: nothing the user needs to act on

} // namespace shadowlab::image
