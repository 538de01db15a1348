// Random numbers that are the same on every compiler and platform.
//
// The generator is SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014).
// It has 64 bits of state, and any seed will do. The distributions are written here because those of the standard
// library may differ between compilers.
#pragma once

#include <cstdint>
#include <string_view>

namespace labmouse {

/// A seeded random number generator. Equal seeds give equal sequences for ever.
class Rng {
 public:
  /// Begins a sequence.
  /// @param seed any number.
  explicit constexpr Rng(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits.
  constexpr std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }

  /// Uniform in [0, 1), in multiples of 2^-53.
  constexpr double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

  /// A random number, uniform from 0 to count - 1 (Lemire's method).
  /// @param count at least 1.
  constexpr int below(int count) {
    const auto sides = static_cast<std::uint32_t>(count);
    // Lemire's method: rejects the few draws that would make some numbers likelier than others.
    const std::uint32_t uneven = (~sides + 1U) % sides;
    for (;;) {
      const auto product = static_cast<std::uint64_t>(static_cast<std::uint32_t>(bits() >> 32U)) * sides;
      if (static_cast<std::uint32_t>(product) >= uneven) return static_cast<int>(product >> 32U);
    }
  }

  /// True with probability times / of.
  /// @param times 0 to `of`.
  /// @param of at least 1.
  constexpr bool chance(int times, int of) { return below(of) < times; }

 private:
  std::uint64_t state_;
};

/// Derives the seed of one of many items (a maze, a run), so that it depends on neither their order nor their count
/// (FNV-1a over the name, then mixed).
/// @param seed common to all items.
/// @param name of the item, byte by byte.
/// @param number tells items of the same name apart, such as the runs in one maze.
constexpr std::uint64_t seed_for(std::uint64_t seed, std::string_view name, std::uint64_t number = 0) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001B3U;
  return Rng(hash ^ Rng(seed).bits() ^ Rng(~number).bits()).bits();
}

}  // namespace labmouse
