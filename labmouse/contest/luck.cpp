#include "labmouse/contest/luck.hpp"

namespace labmouse {

Luck luck_of(const Specimen& mouse) {
  constexpr std::array<double, 5> weak = {0.4, 0.3, 0.25, 0.2, 0.15};
  constexpr double apart = 0.4, far_apart = 0.8;
  const double weakest = mouse.weakest();
  std::size_t below = 0;
  while (below < weak.size() && weakest < weak[below]) ++below;
  if (below > 0) return all_luck[static_cast<std::size_t>(Luck::eyes_far_apart) + below];
  const double eyes = mouse.eyes_apart();
  return eyes > far_apart ? Luck::eyes_far_apart : eyes > apart ? Luck::eyes_apart : Luck::sound;
}

}  // namespace labmouse
