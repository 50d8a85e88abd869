// Four floats at once: four boxes, or four triangles, tested by one instruction where the processor can (SSE), and by
// four where it cannot, with the same bits.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace shadowlab::trace {

#if defined(__SSE2__)

struct Float4 {
    __m128 v;
    static Float4 all(float x) { return {_mm_set1_ps(x)}; }
    static Float4 load(const float* four) { return {_mm_load_ps(four)}; } ///< aligned to 16 bytes
    void store(float* four) const { _mm_store_ps(four, v); }
};
inline Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
inline Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
inline Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
/// Of a NaN and a number, the second argument.
inline Float4 smaller(Float4 a, Float4 b) { return {_mm_min_ps(a.v, b.v)}; }
inline Float4 larger(Float4 a, Float4 b) { return {_mm_max_ps(a.v, b.v)}; }
inline Float4 magnitude(Float4 a) { return {_mm_andnot_ps(_mm_set1_ps(-0.0f), a.v)}; }
/// One bit per lane in which the comparison holds.
inline int whereAtMost(Float4 a, Float4 b) { return _mm_movemask_ps(_mm_cmple_ps(a.v, b.v)); }
inline int whereLess(Float4 a, Float4 b) { return _mm_movemask_ps(_mm_cmplt_ps(a.v, b.v)); }
/// Zero in place of the fourth.
inline Float4 firstThree(Float4 a) { return {_mm_and_ps(a.v, _mm_castsi128_ps(_mm_set_epi32(0, -1, -1, -1)))}; }
/// Whole numbers, without what is behind the point; aligned to 16 bytes.
inline void truncate(Float4 a, std::int32_t* four) {
    _mm_store_si128(reinterpret_cast<__m128i*>(four), _mm_cvttps_epi32(a.v));
}

#else

struct Float4 {
    float v[4];
    static Float4 all(float x) { return {{x, x, x, x}}; }
    static Float4 load(const float* four) { return {{four[0], four[1], four[2], four[3]}}; }
    void store(float* four) const {
        for (int i = 0; i < 4; ++i)
            four[i] = v[i];
    }
};
template <typename F>
Float4 perLane(Float4 a, Float4 b, F f) {
    return {{f(a.v[0], b.v[0]), f(a.v[1], b.v[1]), f(a.v[2], b.v[2]), f(a.v[3], b.v[3])}};
}
template <typename F>
int laneBits(Float4 a, Float4 b, F f) {
    return f(a.v[0], b.v[0]) | f(a.v[1], b.v[1]) << 1 | f(a.v[2], b.v[2]) << 2 | f(a.v[3], b.v[3]) << 3;
}
inline Float4 operator+(Float4 a, Float4 b) {
    return perLane(a, b, [](float x, float y) { return x + y; });
}
inline Float4 operator-(Float4 a, Float4 b) {
    return perLane(a, b, [](float x, float y) { return x - y; });
}
inline Float4 operator*(Float4 a, Float4 b) {
    return perLane(a, b, [](float x, float y) { return x * y; });
}
/// Of a NaN and a number, the second argument.
inline Float4 smaller(Float4 a, Float4 b) {
    return perLane(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline Float4 larger(Float4 a, Float4 b) {
    return perLane(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Float4 magnitude(Float4 a) {
    return perLane(a, a, [](float x, float) { return x < 0 ? -x : x; });
}
/// One bit per lane in which the comparison holds.
inline int whereAtMost(Float4 a, Float4 b) {
    return laneBits(a, b, [](float x, float y) { return int(x <= y); });
}
inline int whereLess(Float4 a, Float4 b) {
    return laneBits(a, b, [](float x, float y) { return int(x < y); });
}
/// Zero in place of the fourth.
inline Float4 firstThree(Float4 a) { return {{a.v[0], a.v[1], a.v[2], 0}}; }
/// Whole numbers, without what is behind the point.
inline void truncate(Float4 a, std::int32_t* four) {
    for (int i = 0; i < 4; ++i)
        four[i] = static_cast<std::int32_t>(a.v[i]);
}

#endif

} // namespace shadowlab::trace
