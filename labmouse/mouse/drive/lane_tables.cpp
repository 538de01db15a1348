#include "labmouse/mouse/drive/lane_tables.hpp"

#include <algorithm>
#include <cassert>

namespace labmouse::drive {
namespace {

StraightTimes backwards(const StraightTimes& times) {
  StraightTimes turned = times;
  const std::size_t count = times.count();
  for (int units = 0; units <= StraightTimes::longest; ++units)
    for (std::size_t from = 0; from < count; ++from)
      for (std::size_t to = 0; to < count; ++to)
        turned.between[(static_cast<std::size_t>(units) * count + to) * count + from] = times.at(units, from, to);
  return turned;
}

/// The kind of node at the other end of a straight.
unsigned kind_behind(unsigned kind, int units) { return kind != diagonal_node && units % 2 != 0 ? 1 - kind : kind; }

NodeKind begin_of(Turn turn) {
  return begins_diagonal(turn) ? diagonal_node : turn == Turn::s90 ? edge_node : centre_node;
}
NodeKind end_of(Turn turn) { return begin_of(reversed(turn)); }

}  // namespace

DriveTables backwards(const DriveTables& tables) {
  DriveTables turned = tables;
  turned.along = backwards(tables.along);
  turned.diagonal = backwards(tables.diagonal);
  std::swap(turned.start, turned.finish);
  for (DrivenTurn& turn : turned.turns) {
    turn.turn = reversed(turn.turn);
    std::swap(turn.from, turn.to);
  }
  return turned;
}

LaneTables::LaneTables(const DriveTables& tables) {
  find_slots(tables);
  find_straights(tables);
  find_reach();
  find_slacks();
  find_turns(tables);
}

void LaneTables::find_slots(const DriveTables& tables) {
  std::array<std::vector<bool>, node_kinds> used;
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    used[kind].resize((kind == diagonal_node ? tables.diagonal : tables.along).count());
  for (const DrivenTurn& turn : tables.turns)
    used[begin_of(turn.turn)][turn.from] = used[end_of(turn.turn)][turn.to] = true;
  for (unsigned kind = 0; kind < node_kinds; ++kind) {
    for (std::size_t lane = 0; lane < used[kind].size(); ++lane) {
      slots_[kind].push_back(used[kind][lane] ? static_cast<int>(lanes_[kind].size()) : no_slot);
      if (used[kind][lane]) lanes_[kind].push_back(lane);
    }
    assert(lanes_[kind].size() <= row);
  }
}

void LaneTables::find_straights(const DriveTables& tables) {
  straights_.assign(place(node_kinds, 0, lengths), no_time);
  finish_.assign(static_cast<std::size_t>(lengths * row), no_time);
  for (int units = 0; units < lengths; ++units)
    for (unsigned kind = 0; kind < node_kinds; ++kind) {
      const StraightTimes& table = kind == diagonal_node ? tables.diagonal : tables.along;
      const auto& from = lanes_[kind_behind(kind, units)];
      for (std::size_t i = 0; i < from.size(); ++i) {
        const std::size_t here = static_cast<std::size_t>(units * row) + i;
        for (unsigned slot = 0; slot < lanes_[kind].size(); ++slot)
          straights_[place(kind, slot, lengths) + here] = table.at(units, from[i], lanes_[kind][slot]);
        if (kind == centre_node) finish_[here] = tables.finish_from(units, from[i]);
      }
    }
}

/// The first length from which on all turns can follow each other.
void LaneTables::find_reach() {
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    for (unsigned slot = 0; slot < lanes_[kind].size(); ++slot)
      for (int units = reach_; units < lengths; ++units)
        for (std::size_t from = 0; from < lanes_[kind_behind(kind, units)].size(); ++from)
          if (straights(kind, slot)[static_cast<std::size_t>(units * row) + from] >= no_time) reach_ = units + 1;
}

void LaneTables::find_slacks() {
  slacks_.assign(place(node_kinds, 0, checks), -no_time);
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    for (unsigned slot = 0; slot < lanes_[kind].size(); ++slot)
      for (int check = 0; check < checks; ++check)
        for (unsigned other = 0; other < lanes_[kind].size(); ++other)
          slacks_[place(kind, slot, checks) + static_cast<std::size_t>(check * row) + other] =
              check == 0 ? slack(kind, slot, 0, other) - 1 : slack(kind, slot, 1 << check, other);
}

DriveTime LaneTables::slack(unsigned kind, unsigned slot, int units, unsigned other) const {
  DriveTime least = no_time;
  for (int before = reach_; units + before < lengths; ++before) {
    const DriveTime* through = straights(kind, slot) + (units + before) * row;
    const DriveTime* over = straights(kind, other) + before * row;
    for (std::size_t from = 0; from < lanes_[kind_behind(kind, before)].size(); ++from)
      least = std::min(least, through[from] - over[from]);
  }
  return least;
}

void LaneTables::find_turns(const DriveTables& tables) {
  for (unsigned kind = 0; kind < node_kinds; ++kind) {
    unsigned count = 0;
    for (unsigned bit = 0; bit < (kind == diagonal_node ? 3U : kind == edge_node ? 2U : 8U); ++bit)
      for (const DrivenTurn& turn : tables.turns)
        if (turn.turn == reversed(turn_of(bit, kind == diagonal_node, kind == edge_node))) {
          const auto slot_of = [&](unsigned at, std::size_t lane) { return static_cast<std::uint8_t>(slot(at, lane)); };
          const TurnBefore before = {slot_of(kind, turn.to), static_cast<std::uint8_t>(bit),
                                     slot_of(begin_of(turn.turn), turn.from), turn.time};
          for (unsigned byte = 0; byte < 256; ++byte) {
            ending_in_[kind][byte] |= (byte >> before.slot & 1U) << count;
            beginning_with_[kind][byte] |= (byte >> bit & 1U) << count;
          }
          turns_[kind][count++] = before;
        }
  }
}

}  // namespace labmouse::drive
