#include "labmouse/strategies/builtin_mice.hpp"

#include <array>

namespace labmouse {

std::span<const BuiltinMouse* const> builtin_mice() {
  static constexpr std::array entries = {
      // Random and fixed rules.
      &random_move_mouse,
      &dead_end_mouse,
      &visit_counter_mouse,
      &random_mouse,
      &random_then_shortest_mouse,
      &cautious_mouse,
      &wall_left_mouse,
      &wall_right_mouse,
      // Planning on a map.
      &manhattan_mouse,
      &frontier_mouse,
      &potential_mouse,
      &two_way_mouse,
      &flood_explore_mouse,
      &flood_block_mouse,
      &phases_mouse,
      &flood_mouse,
      &flood_return_mouse,
      &certify_mouse,
      &ariadne_mouse,
      &ariadne_deep_mouse,
  };
  return entries;
}

std::span<const BuiltinMouse* const> only_drivers() {
  static constexpr std::array entries = {&festina_mouse};
  return entries;
}

std::vector<const BuiltinMouse*> all_mice() {
  std::vector<const BuiltinMouse*> all(builtin_mice().begin(), builtin_mice().end());
  all.insert(all.end(), only_drivers().begin(), only_drivers().end());
  return all;
}

const BuiltinMouse* find_mouse(std::string_view name) {
  for (const auto& entries : {builtin_mice(), only_drivers()})
    for (const BuiltinMouse* entry : entries)
      if (entry->name == name) return entry;
  return nullptr;
}

}  // namespace labmouse
