// The radical inverse, of which sequences are made that fill an interval evenly.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab {

/// The digits of i >= 0 in that base, mirrored at the point: of base 2, 1 is 0.5, 2 is 0.25, 3 is 0.75. In [0, 1). J. van der Corput, 1935.
inline double radicalInverse(int i, int base) {
    double value = 0, digit = 1.0 / base;
    for (; i > 0; i /= base, digit /= base)
        value += digit * (i % base);
    return value;
}

} // namespace shadowlab
