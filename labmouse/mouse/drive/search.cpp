#include "labmouse/mouse/drive/search.hpp"

#include "labmouse/mouse/drive/lane_tables.hpp"

namespace labmouse::drive {
namespace {

/// Whether a robot has one speed at all nodes, at its start and in the goal, and each turn in one way, backwards as
/// well.
bool one_speed(const DriveTables& tables) {
  if (tables.along.count() != 1 || tables.diagonal.count() != 1 || tables.turns.size() != all_turns.size())
    return false;
  for (const Turn turn : all_turns) {
    const DrivenTurn& driven = tables.turns[static_cast<std::size_t>(turn)];
    if (driven.turn != turn || driven.time != tables.turns[static_cast<std::size_t>(reversed(turn))].time) return false;
  }
  return tables.start == tables.finish && tables.start == tables.along.between;
}

}  // namespace

int bucket_shift(const DriveTables& tables) {
  return static_cast<int>(std::bit_width(static_cast<std::uint32_t>(tables.shortest_turn())));
}

std::unique_ptr<SearchMaker> make_searches(const DriveTables& tables, const Leaps& leaps) {
  if (one_speed(tables)) return make_fixed_searches(tables, leaps);
  return speeds_for(tables) == 1 ? make_lead_searches(tables, leaps) : make_lane_searches(tables, leaps);
}

}  // namespace labmouse::drive
