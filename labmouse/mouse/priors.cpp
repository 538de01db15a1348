#include "labmouse/mouse/priors.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace labmouse {
namespace {

using Numbers = std::array<std::uint8_t, wall_contexts + rim_contexts>;

constexpr WallPrior prior_of(const Numbers& numbers) {
  WallPrior prior{};
  const auto rim = numbers.begin() + wall_contexts;
  std::copy(numbers.begin(), rim, prior.walls.begin());
  std::copy(rim, numbers.end(), prior.rim.begin());
  return prior;
}

// As `labmouse learn` wrote them: numbers with commas between them.
constexpr Numbers contest_numbers = {
#include "labmouse/mouse/contest.prior"
};
constexpr Numbers loop_free_numbers = {
#include "labmouse/mouse/loop_free.prior"
};

}  // namespace

constinit const WallPrior contest_prior = prior_of(contest_numbers);
constinit const WallPrior loop_free_prior = prior_of(loop_free_numbers);

const WallPrior* contest_prior_for(Size size) {
  constexpr int smallest = 8;
  return std::min(size.width, size.height) >= smallest ? &contest_prior : nullptr;
}

int complement(int reluctance) {
  // round(-32 ln(1 - exp(-n / 32))); entry 0 is never used.
  static constexpr std::array<std::uint8_t, 113> table = {
      0,  111, 90, 77, 69, 62, 57, 52, 48, 45, 42, 40, 37, 35, 33, 31, 30, 28, 27, 26, 25, 23, 22,
      21, 20,  20, 19, 18, 17, 17, 16, 15, 15, 14, 14, 13, 13, 12, 12, 11, 11, 10, 10, 10, 9,  9,
      9,  8,   8,  8,  8,  7,  7,  7,  7,  6,  6,  6,  6,  6,  5,  5,  5,  5,  5,  4,  4,  4,  4,
      4,  4,   4,  4,  3,  3,  3,  3,  3,  3,  3,  3,  3,  3,  2,  2,  2,  2,  2,  2,  2,  2,  2,
      2,  2,   2,  2,  2,  2,  2,  1,  1,  1,  1,  1,  1,  1,  1,  1,  1,  1,  1,  1,  1,
  };
  return table[static_cast<unsigned>(reluctance)];
}

}  // namespace labmouse
