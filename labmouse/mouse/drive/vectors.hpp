// Vectors of four times, by the vector extensions of the compilers.
#pragma once

#include <cstring>

#include "labmouse/mouse/drive/lattice.hpp"
#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse::drive {

inline constexpr int width = 4;
using Times = std::int32_t __attribute__((vector_size(4 * width)));

inline Times load(const DriveTime* from) {
  Times times;
  std::memcpy(&times, from, sizeof(times));
  return times;
}
inline void store(DriveTime* to, Times times) { std::memcpy(to, &times, sizeof(times)); }

/// Sets so many times to no_time.
inline void forget(DriveTime* times, std::size_t count) {
  static_assert(no_time == 0x3f3f3f3f);
  std::memset(times, 0x3f, count * sizeof(*times));
}

/// The sign bits of four lanes; for a comparison, the lanes in which it holds.
inline unsigned bits_of(Times lanes) {
#if defined(__SSE2__)
  using Floats = float __attribute__((vector_size(16)));
  return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<Floats>(lanes)));
#elif defined(__wasm_simd128__)
  return static_cast<unsigned>(__builtin_wasm_bitmask_i32x4(lanes));
#else
  unsigned bits = 0;
  for (int i = 0; i < width; ++i) bits |= (lanes[i] < 0 ? 1U : 0U) << i;
  return bits;
#endif
}

/// The turns that can begin at a node: one bit of each of eight words.
template <class Word>
unsigned turn_bits(const Lattice<Word>& lattice, int node) {
#if defined(__SSE2__)
  using Longs = long long __attribute__((vector_size(16)));
  using Doubles = double __attribute__((vector_size(16)));
  const Word* words = lattice.turns(node);
  const int left = Lattice<Word>::points - 1 - node % Lattice<Word>::points;
  unsigned bits = 0;
  if constexpr (sizeof(Word) == sizeof(std::uint32_t)) {
    for (int half = 0; half < 2; ++half) {
      Times four;
      std::memcpy(&four, words + 4 * half, sizeof(four));
      bits |= bits_of(four << left) << 4 * half;
    }
  } else {
    for (int quarter = 0; quarter < 4; ++quarter) {
      Longs two;
      std::memcpy(&two, words + 2 * quarter, sizeof(two));
      bits |= static_cast<unsigned>(__builtin_ia32_movmskpd(reinterpret_cast<Doubles>(two << left))) << 2 * quarter;
    }
  }
  return bits;
#else
  return lattice.turns_at(node);
#endif
}

}  // namespace labmouse::drive
