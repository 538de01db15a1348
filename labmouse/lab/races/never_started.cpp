#include "labmouse/lab/races/never_started.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/text/printable.hpp"

namespace labmouse {

std::string never_started_lines(const Race& race) {
  std::string lines;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    const auto held = [&](const ContestResult& result) { return result.mouse == mouse && result.done; };
    const auto raced = [&](const ContestResult& result) { return held(result) && result.never_started.empty(); };
    const auto first = std::find_if(race.results.begin(), race.results.end(), held);
    if (first == race.results.end() || std::any_of(race.results.begin(), race.results.end(), raced)) continue;
    lines +=
        shown(fmt::format("{} failed to start in every contest: {}", race.mice[mouse].name, first->never_started)) +
        "\n";
  }
  return lines;
}

}  // namespace labmouse
