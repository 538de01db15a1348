// Chance, the same on every compiler and platform.
//
// The generator is SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014):
// 64 bits of state, any seed is a good one. The distributions are our own, because those of the standard library may
// differ from one compiler to the next.
#pragma once

#include <cstdint>
#include <string_view>

namespace labmouse {

/// A seeded source of chance. Equal seeds give equal throws for ever.
class Dice {
 public:
  explicit constexpr Dice(std::uint64_t seed) : state_(seed) {}

  /// 64 fair bits.
  constexpr std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }

  /// A number from 0 to 1, without 1; each multiple of 2^-53 is as likely as the others.
  constexpr double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

  /// A number from 0 to count - 1, each as likely as the others; count must be at least 1.
  constexpr int below(int count) {
    const auto sides = static_cast<std::uint32_t>(count);
    // Throw again in the short last stretch, so that no number comes up more often than another.
    const std::uint32_t uneven = (~sides + 1U) % sides;
    for (;;) {
      const auto product = static_cast<std::uint64_t>(static_cast<std::uint32_t>(bits() >> 32U)) * sides;
      if (static_cast<std::uint32_t>(product) >= uneven) return static_cast<int>(product >> 32U);
    }
  }

  /// True in `times` of `of` throws on average; 0 <= times <= of, of >= 1.
  constexpr bool chance(int times, int of) { return below(of) < times; }

 private:
  std::uint64_t state_;
};

/// A seed for one of many things (a maze, a run) made from a common seed and a name, so that neither the order nor the
/// number of the things matters (FNV-1a over the name, then mixed).
constexpr std::uint64_t seed_for(std::uint64_t seed, std::string_view name, std::uint64_t number = 0) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001B3U;
  return Dice(hash ^ Dice(seed).bits() ^ Dice(~number).bits()).bits();
}

}  // namespace labmouse
