// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/judge/exact_sign.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace shadowlab::trace {

namespace {

/// A number as the unevaluated sum of two doubles that do not overlap.
struct Two {
    double high, low;
};

/// a - b without error (Knuth, 1969).
Two difference(double a, double b) {
    const double high = a - b;
    const double bVirtual = a - high, aVirtual = high + bVirtual;
    return {high, (a - aVirtual) + (bVirtual - b)};
}

/// a * b without error: the fused multiply-add yields what rounding took away.
Two product(double a, double b) {
    const double high = a * b;
    return {high, std::fma(a, b, -high)};
}

/// Sum and product of such numbers, to twice the digits of double: wrong by less than 2^-102 of the sum of what is put together
/// without signs (Dekker, 1971; the sum's bound is Li and others', "Design, Implementation and Testing of Extended and Mixed
/// Precision BLAS", 2002).
Two operator+(const Two& a, const Two& b) {
    const Two high = difference(a.high, -b.high);
    const double low = high.low + (a.low + b.low), sum = high.high + low;
    return {sum, low - (sum - high.high)};
}
Two operator-(const Two& a) { return {-a.high, -a.low}; }
Two operator*(const Two& a, const Two& b) {
    const Two high = product(a.high, b.high);
    const double low = high.low + (a.high * b.low + a.low * b.high), sum = high.high + low;
    return {sum, low - (sum - high.high)};
}

/// A sum that loses nothing: parts that do not overlap, smallest first. Its sign is that of the largest part.
class Sum {
public:
    void add(double value) { // Shewchuk's GROW-EXPANSION, dropping zeros
        if (value == 0) return;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double high = value + parts_[i];
            const double virtualPart = high - value, virtualValue = high - virtualPart;
            const double low = (value - virtualValue) + (parts_[i] - virtualPart);
            value = high;
            if (low != 0) parts_[kept++] = low;
        }
        if (value != 0) parts_[kept++] = value;
        count_ = kept;
    }
    void addProduct(double a, double b, double c) {
        const Two ab = product(a, b);
        for (const double part : {ab.low, ab.high}) {
            const Two abc = product(part, c);
            add(abc.low);
            add(abc.high);
        }
    }
    [[nodiscard]] int sign() const { return count_ == 0 ? 0 : parts_[count_ - 1] > 0 ? 1 : -1; }

private:
    std::array<double, 96> parts_; ///< six products of three, of 1 x 2 x 2 parts, four doubles each
    std::size_t count_ = 0;
};

} // namespace

int exactTripleSign(const dvec3& direction, const dvec3& origin, const dvec3& b, const dvec3& c) {
    if (b == c) return 0; // an edge without length, of a triangle without area
    std::array<Two, 3> fromOriginB{}, fromOriginC{};
    for (int axis = 0; axis < 3; ++axis) {
        fromOriginB[static_cast<std::size_t>(axis)] = difference(b[axis], origin[axis]);
        fromOriginC[static_cast<std::size_t>(axis)] = difference(c[axis], origin[axis]);
    }
    // direction[i] * (B[j] C[k] - B[k] C[j]): with twice the digits first. Each of at most six operations that a term goes
    // through loses 2^-102 of `size` or less.
    Two value{0, 0};
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double factor = direction[static_cast<int>(i)];
        const Two plus = fromOriginB[j] * fromOriginC[k], minus = fromOriginB[k] * fromOriginC[j];
        value = value + Two{factor, 0} * (plus + -minus);
        size += std::abs(factor) * (std::abs(plus.high) + std::abs(minus.high));
    }
    if (std::abs(value.high) > 0x1p-98 * size) return value.high > 0 ? 1 : -1;

    Sum sum;
    // Most differences of coordinates need no second part, so of four products three are nothing.
    const auto addTerm = [&](double factor, const Two& p, const Two& q) {
        if (factor == 0) return;
        for (const double pPart : {p.low, p.high})
            for (const double qPart : {q.low, q.high})
                if (pPart != 0 && qPart != 0) sum.addProduct(pPart, qPart, factor);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double factor = direction[static_cast<int>(i)];
        addTerm(factor, fromOriginB[j], fromOriginC[k]);
        addTerm(-factor, fromOriginB[k], fromOriginC[j]);
    }
    return sum.sign();
}

} // namespace shadowlab::trace
