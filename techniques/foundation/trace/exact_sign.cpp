// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/exact_sign.h"

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

/// A sum that loses nothing: parts that do not overlap, smallest first. Its sign is that of the largest part.
class Sum {
public:
    void add(double value) { // Shewchuk's GROW-EXPANSION, dropping zeros
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
    std::array<double, 96> parts_{}; ///< six products of three, of 1 x 2 x 2 parts, four doubles each
    std::size_t count_ = 0;
};

} // namespace

int exactTripleSign(const dvec3& direction, const dvec3& origin, const dvec3& b, const dvec3& c) {
    std::array<Two, 3> fromOriginB{}, fromOriginC{};
    for (int axis = 0; axis < 3; ++axis) {
        fromOriginB[static_cast<std::size_t>(axis)] = difference(b[axis], origin[axis]);
        fromOriginC[static_cast<std::size_t>(axis)] = difference(c[axis], origin[axis]);
    }
    Sum sum;
    const auto addTerm = [&](double factor, const Two& p, const Two& q) {
        for (const double pPart : {p.low, p.high})
            for (const double qPart : {q.low, q.high})
                sum.addProduct(pPart, qPart, factor);
    };
    for (std::size_t i = 0; i < 3; ++i) { // direction[i] * (B[j] C[k] - B[k] C[j])
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double factor = direction[static_cast<int>(i)];
        addTerm(factor, fromOriginB[j], fromOriginC[k]);
        addTerm(-factor, fromOriginB[k], fromOriginC[j]);
    }
    return sum.sign();
}

} // namespace shadowlab::trace
