#pragma once
#include <cstdint>

/// On a function that loops over pixels: wider vectors where the processor has them. Results are the same
/// bit for bit: no multiplication is fused with an addition.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(VANTAGE_SANITIZED)  // whose start comes too late
#define VANTAGE_SIMD __attribute__((target_clones("avx2", "default")))
#else
#define VANTAGE_SIMD
#endif

namespace vantage {

/// Numbers that such a loop works on at once, where it is written out.
inline constexpr int lanes = 8;
using Ints = std::int32_t __attribute__((vector_size(4 * lanes)));
using Floats = float __attribute__((vector_size(4 * lanes)));

}  // namespace vantage

/// On a function that such a loop calls: part of it, and as wide.
#define VANTAGE_INLINE __attribute__((always_inline)) inline
