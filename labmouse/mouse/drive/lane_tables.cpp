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

/// The lanes in which turns begin or end, by kind of node.
std::array<std::vector<std::size_t>, node_kinds> lanes_at_nodes(const DriveTables& tables) {
  std::array<std::vector<std::size_t>, node_kinds> lanes;
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    for (std::size_t lane = 0; lane < (kind == diagonal_node ? tables.diagonal : tables.along).count(); ++lane)
      if (std::any_of(tables.turns.begin(), tables.turns.end(), [&](const DrivenTurn& turn) {
            return (begin_of(turn.turn) == kind && turn.from == lane) || (end_of(turn.turn) == kind && turn.to == lane);
          }))
        lanes[kind].push_back(lane);
  return lanes;
}

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

unsigned speeds_for(const DriveTables& tables) {
  const auto lanes = lanes_at_nodes(tables);
  for (const unsigned speeds : {1U, 2U, 4U, 6U, 8U}) {
    bool enough = true;
    for (unsigned kind = 0; kind < node_kinds; ++kind)
      enough = enough && lanes[kind].size() <= slots_a_speed[kind] * speeds;
    if (enough) return speeds;
  }
  return 0;
}

LaneTables::LaneTables(const DriveTables& tables, unsigned speeds)
    : speeds_(speeds), rooms_(tables.rooms()), lanes_(lanes_at_nodes(tables)) {
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    first_row_[kind + 1] = first_row_[kind] + slots_a_speed[kind] * speeds * row(kind);
  find_slots(tables);
  find_straights(tables);
  find_reach();
  find_slacks();
  find_turns(tables);
}

void LaneTables::find_slots(const DriveTables& tables) {
  for (unsigned kind = 0; kind < node_kinds; ++kind) {
    slots_[kind].assign((kind == diagonal_node ? tables.diagonal : tables.along).count(), no_slot);
    for (std::size_t slot = 0; slot < lanes_[kind].size(); ++slot)
      slots_[kind][lanes_[kind][slot]] = static_cast<int>(slot);
    assert(lanes_[kind].size() <= slots_a_speed[kind] * speeds_);
  }
}

void LaneTables::find_straights(const DriveTables& tables) {
  straights_.assign(place(node_kinds, 0, lengths), no_time);
  finish_.assign(static_cast<std::size_t>(rooms_ * lengths) * row(centre_node), no_time);
  for (int units = 0; units < lengths; ++units)
    for (unsigned kind = 0; kind < node_kinds; ++kind) {
      const StraightTimes& table = kind == diagonal_node ? tables.diagonal : tables.along;
      const auto& from = lanes_[kind_behind(kind, units)];
      const std::size_t here = static_cast<std::size_t>(units) * row(kind);
      for (std::size_t i = 0; i < from.size(); ++i) {
        for (unsigned slot = 0; slot < lanes_[kind].size(); ++slot)
          straights_[place(kind, slot, lengths) + here + i] = table.at(units, from[i], lanes_[kind][slot]);
        if (kind != centre_node) continue;
        for (int room = 0; room < rooms_; ++room)
          finish_[static_cast<std::size_t>(room * lengths) * row(kind) + here + i] =
              tables.finish_from(units, from[i], room);
      }
    }
}

/// The first length from which on all turns can follow each other.
void LaneTables::find_reach() {
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    for (unsigned slot = 0; slot < lanes_[kind].size(); ++slot)
      for (int units = reach_; units < lengths; ++units)
        for (std::size_t from = 0; from < lanes_[kind_behind(kind, units)].size(); ++from)
          if (straights(kind, slot)[static_cast<std::size_t>(units) * row(kind) + from] >= no_time) reach_ = units + 1;
}

void LaneTables::find_slacks() {
  slacks_.assign(place(node_kinds, 0, checks), -no_time);
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    for (unsigned slot = 0; slot < lanes_[kind].size(); ++slot)
      for (int check = 0; check < checks; ++check)
        for (unsigned other = 0; other < lanes_[kind].size(); ++other)
          slacks_[place(kind, slot, checks) + static_cast<std::size_t>(check) * row(kind) + other] =
              check == 0 ? slack(kind, slot, 0, other) - 1 : slack(kind, slot, 1 << check, other);
}

DriveTime LaneTables::slack(unsigned kind, unsigned slot, int units, unsigned other) const {
  DriveTime least = no_time;
  for (int before = reach_; units + before < lengths; ++before) {
    const DriveTime* through = straights(kind, slot) + static_cast<std::size_t>(units + before) * row(kind);
    const DriveTime* over = straights(kind, other) + static_cast<std::size_t>(before) * row(kind);
    for (std::size_t from = 0; from < lanes_[kind_behind(kind, before)].size(); ++from)
      least = std::min(least, through[from] - over[from]);
  }
  return least;
}

void LaneTables::find_turns(const DriveTables& tables) {
  for (unsigned kind = 0; kind < node_kinds; ++kind) {
    turns_[kind].resize(lanes_[kind].size());
    for (unsigned bit = 0; bit < (kind == diagonal_node ? 3U : kind == edge_node ? 2U : 8U); ++bit)
      for (const DrivenTurn& turn : tables.turns)
        if (turn.turn == reversed(turn_of(bit, kind == diagonal_node, kind == edge_node)))
          turns_[kind][static_cast<std::size_t>(slot(kind, turn.to))].push_back(
              {static_cast<std::uint8_t>(bit), static_cast<std::uint8_t>(slot(begin_of(turn.turn), turn.from)),
               turn.time});
  }
}

}  // namespace labmouse::drive
