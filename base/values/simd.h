#pragma once
#include <cstdint>
#include <cstring>

/// Marks a function that loops over pixels. The function is compiled both for AVX2 and for the baseline; one
/// version is selected at program start. The two versions give bit-identical results, because AVX2 without
/// FMA has no fused multiply-add. With sanitizers, there is only one version, because sanitizers are
/// initialized after the selection.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(VANTAGE_SANITIZED)
#define VANTAGE_SIMD __attribute__((target_clones("avx2", "default")))
#else
#define VANTAGE_SIMD
#endif

/// Marks a function that is called in a loop over pixels. The function must be inlined so that it is compiled
/// for the same instruction set as the loop.
#define VANTAGE_INLINE __attribute__((always_inline)) inline

namespace vantage {

/// Vectors for loops vectorized by hand, and their number of elements.
inline constexpr int lanes = 8;
using Ints = std::int32_t __attribute__((vector_size(4 * lanes)));
using Floats = float __attribute__((vector_size(4 * lanes)));
using Doubles = double __attribute__((vector_size(8 * lanes)));

/// Loads elements from `at`, which need not be aligned.
template <class Vector, class T>
VANTAGE_INLINE void load(Vector& elements, const T* at) {
    static_assert(sizeof(T) * lanes == sizeof elements);
    std::memcpy(&elements, at, sizeof elements);
}
template <class Vector, class T>
VANTAGE_INLINE void store(const Vector& elements, T* at) {
    static_assert(sizeof(T) * lanes == sizeof elements);
    std::memcpy(at, &elements, sizeof elements);
}

template <class Vector>
VANTAGE_INLINE Vector least(const Vector& a, const Vector& b) {
    return b < a ? b : a;
}
template <class Vector>
VANTAGE_INLINE Vector greatest(const Vector& a, const Vector& b) {
    return a < b ? b : a;
}

}  // namespace vantage
