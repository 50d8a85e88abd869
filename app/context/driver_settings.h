// Environment variables of Mesa's own developers.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::context {

/// Some of Mesa's settings end the program in the middle of a picture, others leave a part of every picture out without a word.
/// Throws Unavailable with the name of the first that does. Every factory of contexts begins with this.
void requireUsableSettings();

} // namespace shadowlab::context
