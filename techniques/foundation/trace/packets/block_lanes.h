// Lanes: eight floats, or four doubles, that one instruction works on.
//
// With AVX2 they are GCC's vector types: + and * work on all lanes, a comparison gives a mask. Other processors have
// vectors of half that length, so there they are two halves, with the same operators. For the two files that block_kernel.h
// is compiled in, and like that with internal linkage.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed between functions of one file only

namespace shadowlab::trace {
namespace {

using FourFloats = float __attribute__((vector_size(16)));
using FourInts = int __attribute__((vector_size(16)));
using FourNumbers = std::uint32_t __attribute__((vector_size(16), aligned(4)));

#if defined(__AVX2__)

using Float8 = float __attribute__((vector_size(32)));
using Mask8 = decltype(Float8{} < Float8{});
using Double4 = double __attribute__((vector_size(32)));
using Mask4 = decltype(Double4{} < Double4{});

inline Float8 all(float v) { return Float8{v, v, v, v, v, v, v, v}; }
inline Double4 four(double a, double b, double c, double d) { return Double4{a, b, c, d}; }
inline Float8 eightOf(const float* place) { return *reinterpret_cast<const Float8*>(place); }
inline Double4 fourOf(const double* place) { return *reinterpret_cast<const Double4*>(place); }
inline void store(float* place, Float8 a) { *reinterpret_cast<Float8*>(place) = a; }
inline void store(double* place, Double4 a) { *reinterpret_cast<Double4*>(place) = a; }
inline void storeFloats(float* place, Double4 a) {
    *reinterpret_cast<FourFloats*>(place) = __builtin_convertvector(a, FourFloats);
}
inline float lane(Float8 a, int i) { return a[i]; }
inline double lane(Double4 a, int i) { return a[i]; }
/// a where the mask is true, b elsewhere.
inline Float8 choose(Mask8 mask, Float8 a, Float8 b) { return mask ? a : b; }
inline Double4 choose(Mask4 mask, Double4 a, Double4 b) { return mask ? a : b; }
/// One bit for each lane that is true.
inline unsigned bits(Mask8 m) { return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(m))); }
inline unsigned bits(Mask4 m) { return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(m))); }

#else

/// Two vectors as one.
template <typename Half>
struct Halves {
    using Number = std::remove_cvref_t<decltype(Half{}[0])>;
    Half low, high;
    friend Halves operator+(Halves a, Halves b) { return {a.low + b.low, a.high + b.high}; }
    friend Halves operator-(Halves a, Halves b) { return {a.low - b.low, a.high - b.high}; }
    friend Halves operator*(Halves a, Halves b) { return {a.low * b.low, a.high * b.high}; }
    friend Halves operator/(Halves a, Halves b) { return {a.low / b.low, a.high / b.high}; }
    friend Halves operator&(Halves a, Halves b) { return {a.low & b.low, a.high & b.high}; }
    friend Halves operator|(Halves a, Halves b) { return {a.low | b.low, a.high | b.high}; }
    friend auto operator<(Halves a, Halves b) { return halves(a.low < b.low, a.high < b.high); }
    friend auto operator>(Halves a, Halves b) { return halves(a.low > b.low, a.high > b.high); }
    friend auto operator<=(Halves a, Halves b) { return halves(a.low <= b.low, a.high <= b.high); }
    friend Halves operator+(Halves a, Number b) { return {a.low + b, a.high + b}; }
    friend Halves operator*(Halves a, Number b) { return {a.low * b, a.high * b}; }
    friend Halves operator*(Number a, Halves b) { return {a * b.low, a * b.high}; }
    friend auto operator<(Halves a, Number b) { return halves(a.low < b, a.high < b); }
    friend auto operator>(Halves a, Number b) { return halves(a.low > b, a.high > b); }
    Halves operator-() const { return {-low, -high}; }
    Halves operator~() const { return {~low, ~high}; }
    Halves& operator+=(Halves b) { return *this = *this + b; }
    Halves& operator&=(Halves b) { return *this = *this & b; }
    Halves& operator|=(Halves b) { return *this = *this | b; }

private:
    template <typename Other>
    static Halves<Other> halves(Other low, Other high) {
        return {low, high};
    }
};

using TwoDoubles = double __attribute__((vector_size(16)));
using Float8 = Halves<FourFloats>;
using Double4 = Halves<TwoDoubles>;
using Mask8 = decltype(Float8{} < Float8{});
using Mask4 = decltype(Double4{} < Double4{});

inline Float8 all(float v) { return {FourFloats{v, v, v, v}, FourFloats{v, v, v, v}}; }
inline Double4 four(double a, double b, double c, double d) { return {TwoDoubles{a, b}, TwoDoubles{c, d}}; }
inline Float8 eightOf(const float* place) {
    return {*reinterpret_cast<const FourFloats*>(place), *reinterpret_cast<const FourFloats*>(place + 4)};
}
inline Double4 fourOf(const double* place) {
    return {*reinterpret_cast<const TwoDoubles*>(place), *reinterpret_cast<const TwoDoubles*>(place + 2)};
}
inline void store(float* place, Float8 a) {
    *reinterpret_cast<FourFloats*>(place) = a.low;
    *reinterpret_cast<FourFloats*>(place + 4) = a.high;
}
inline void store(double* place, Double4 a) {
    *reinterpret_cast<TwoDoubles*>(place) = a.low;
    *reinterpret_cast<TwoDoubles*>(place + 2) = a.high;
}
inline void storeFloats(float* place, Double4 a) {
    for (int i = 0; i < 2; ++i) {
        place[i] = static_cast<float>(a.low[i]);
        place[i + 2] = static_cast<float>(a.high[i]);
    }
}
inline float lane(Float8 a, int i) { return i < 4 ? a.low[i] : a.high[i - 4]; }
inline double lane(Double4 a, int i) { return i < 2 ? a.low[i] : a.high[i - 2]; }
/// a where the mask is true, b elsewhere.
template <typename Mask, typename Half>
Halves<Half> choose(Mask mask, Halves<Half> a, Halves<Half> b) {
    return {mask.low ? a.low : b.low, mask.high ? a.high : b.high};
}
/// One bit for each lane that is true.
inline unsigned bits(Mask8 m) {
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(m.low)) |
                                 _mm_movemask_ps(reinterpret_cast<__m128>(m.high)) << 4);
#else
    unsigned set = 0;
    for (int i = 0; i < 4; ++i)
        set |= static_cast<unsigned>((m.low[i] & 1) | (m.high[i] & 16)) << i;
    return set;
#endif
}
inline unsigned bits(Mask4 m) {
    return static_cast<unsigned>((m.low[0] & 1) | (m.low[1] & 2) | (m.high[0] & 4) | (m.high[1] & 8));
}

#endif

constexpr float kNever = -std::numeric_limits<float>::infinity();

inline Double4 all(double v) { return four(v, v, v, v); }
inline FourFloats four(float v) { return FourFloats{v, v, v, v}; }
inline Double4 magnitude(Double4 a) { return choose(a < 0.0, -a, a); }
#if defined(__AVX2__)
inline Double4 larger(Double4 a, Double4 b) { return _mm256_max_pd(a, b); }
inline Double4 smaller(Double4 a, Double4 b) { return _mm256_min_pd(a, b); }
#else
inline Double4 larger(Double4 a, Double4 b) { return choose(a > b, a, b); }
inline Double4 smaller(Double4 a, Double4 b) { return choose(a < b, a, b); }
#endif
/// Of a NaN and a number, the second argument; so do all of these.
#if defined(__AVX2__)
inline Float8 larger(Float8 a, Float8 b) { return _mm256_max_ps(a, b); }
inline Float8 smaller(Float8 a, Float8 b) { return _mm256_min_ps(a, b); }
#else
inline Float8 larger(Float8 a, Float8 b) { return choose(a > b, a, b); }
inline Float8 smaller(Float8 a, Float8 b) { return choose(a < b, a, b); }
#endif
inline FourFloats smaller(FourFloats a, FourFloats b) { return a < b ? a : b; }
inline FourFloats larger(FourFloats a, FourFloats b) { return a > b ? a : b; }

inline unsigned bits(FourInts m) {
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(m)));
#else
    return static_cast<unsigned>((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
#endif
}

/// One bit for each of eight numbers that is this one.
inline unsigned equal(const std::uint32_t* eight, std::uint32_t n) {
    const FourNumbers wanted{n, n, n, n};
    return bits(FourInts(*reinterpret_cast<const FourNumbers*>(eight) == wanted)) |
           bits(FourInts(*reinterpret_cast<const FourNumbers*>(eight + 4) == wanted)) << 4;
}

/// Writes a number over those of eight that the mask marks. (The lanes of a mask are all ones, or zero.)
inline void replace(std::uint32_t* eight, Mask8 mask, std::uint32_t n) {
#if defined(__AVX2__)
    const __m256i old = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(eight));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(eight),
                        _mm256_blendv_epi8(old, _mm256_set1_epi32(static_cast<int>(n)), __m256i(mask)));
#else
    for (int i = 0; i < 4; ++i) {
        eight[i] = mask.low[i] ? n : eight[i];
        eight[i + 4] = mask.high[i] ? n : eight[i + 4];
    }
#endif
}

/// Of eight rows of eight, the smallest of each row.
inline Float8 smallestOfRows(const float* rows) {
#if defined(__AVX2__)
    // Neighbours are compared, then pairs, then halves; what changes places on the way comes out in the order of the rows.
    const auto pairs = [](Float8 a, Float8 b) {
        return smaller(Float8(_mm256_unpacklo_ps(a, b)), Float8(_mm256_unpackhi_ps(a, b)));
    };
    const auto fours = [](Float8 a, Float8 b) {
        return smaller(Float8(_mm256_shuffle_ps(a, b, 0x44)), Float8(_mm256_shuffle_ps(a, b, 0xee)));
    };
    const auto row = [&](int r) { return eightOf(rows + 8 * r); };
    const Float8 first = fours(pairs(row(0), row(1)), pairs(row(2), row(3)));
    const Float8 second = fours(pairs(row(4), row(5)), pairs(row(6), row(7)));
    return smaller(Float8(_mm256_permute2f128_ps(first, second, 0x20)),
                   Float8(_mm256_permute2f128_ps(first, second, 0x31)));
#else
    alignas(16) float smallest[8];
    for (int row = 0; row < 8; ++row) {
        const Float8 eight = eightOf(rows + 8 * row);
        const FourFloats half = smaller(eight.low, eight.high);
        const float low = half[0] < half[1] ? half[0] : half[1], high = half[2] < half[3] ? half[2] : half[3];
        smallest[row] = low < high ? low : high;
    }
    return eightOf(smallest);
#endif
}

} // namespace
} // namespace shadowlab::trace
