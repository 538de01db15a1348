#include "labmouse/mouse/drive/lane_tables.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

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
      enough = enough && lanes[kind].size() <= (end_slot_a_speed[kind] - first_slot_a_speed[kind]) * speeds;
    if (enough) return speeds;
  }
  return 0;
}

LaneTables::LaneTables(const DriveTables& tables, unsigned speeds) : speeds_(speeds), rooms_(tables.rooms()) {
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    first_row_[kind + 1] = first_row_[kind] + end_slot_a_speed[kind] * speeds * row(kind);
  find_slots(tables);
  find_straights(tables);
  find_reach();
  find_slacks();
  find_turns(tables);
}

std::size_t LaneTables::bytes() const {
  std::size_t bytes = sizeof(*this) + sizeof(DriveTime) * (straights_.size() + finish_.size() + slacks_.size());
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    bytes += sizeof(int) * slots_[kind].size() + sizeof(Slot) * used_[kind].size() +
             sizeof(TurnBefore) * turns_[kind].size();
  return bytes;
}

void LaneTables::find_slots(const DriveTables& tables) {
  const auto lanes = lanes_at_nodes(tables);
  for (unsigned kind = 0; kind < node_kinds; ++kind) {
    slots_[kind].assign((kind == diagonal_node ? tables.diagonal : tables.along).count(), no_slot);
    unsigned slot = first_slot_a_speed[kind] * speeds_;
    for (const std::size_t lane : lanes[kind]) {
      used_[kind].push_back({slot, lane});
      slots_[kind][lane] = static_cast<int>(slot++);
    }
    assert(slot <= end_slot_a_speed[kind] * speeds_);
  }
}

void LaneTables::find_straights(const DriveTables& tables) {
  straights_.assign(first_row_[node_kinds] * lengths, no_time);
  finish_.assign(static_cast<std::size_t>(rooms_ * lengths) * row(centre_node), no_time);
  for (int units = 0; units < lengths; ++units)
    for (unsigned kind = 0; kind < node_kinds; ++kind) {
      const StraightTimes& table = kind == diagonal_node ? tables.diagonal : tables.along;
      const std::size_t here = static_cast<std::size_t>(units) * row(kind);
      for (const Slot& from : used_[kind_behind(kind, units)]) {
        for (const Slot& to : used_[kind])
          straights_[place(kind, to.number, lengths) + here + from.number] = table.at(units, from.lane, to.lane);
        if (kind != centre_node) continue;
        for (int room = 0; room < rooms_; ++room)
          finish_[static_cast<std::size_t>(room * lengths) * row(kind) + here + from.number] =
              tables.finish_from(units, from.lane, room);
      }
    }
}

/// Finds the least length from which on any turn can follow any other.
void LaneTables::find_reach() {
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    for (const Slot& to : used_[kind])
      for (int units = reach_; units < lengths; ++units)
        for (const Slot& from : used_[kind_behind(kind, units)])
          if (straights(kind, to.number)[static_cast<std::size_t>(units) * row(kind) + from.number] >= no_time)
            reach_ = units + 1;
}

void LaneTables::find_slacks() {
  slacks_.assign(first_row_[node_kinds] * checks, -no_time);
  for (unsigned kind = 0; kind < node_kinds; ++kind)
    for (const Slot& slot : used_[kind])
      for (int check = 0; check < checks; ++check)
        for (const Slot& other : used_[kind])
          slacks_[place(kind, slot.number, checks) + static_cast<std::size_t>(check) * row(kind) + other.number] =
              check == 0 ? slack(kind, slot.number, 0, other.number) - 1
                         : slack(kind, slot.number, 1 << check, other.number);
}

DriveTime LaneTables::slack(unsigned kind, unsigned slot, int units, unsigned other) const {
  DriveTime least = no_time;
  for (int before = reach_; units + before < lengths; ++before) {
    const DriveTime* through = straights(kind, slot) + static_cast<std::size_t>(units + before) * row(kind);
    const DriveTime* over = straights(kind, other) + static_cast<std::size_t>(before) * row(kind);
    for (const Slot& from : used_[kind_behind(kind, before)])
      least = std::min(least, through[from.number] - over[from.number]);
  }
  return least;
}

void LaneTables::find_turns(const DriveTables& tables) {
  for (unsigned kind = 0; kind < node_kinds; ++kind) {
    unsigned count = 0;
    for (unsigned bit = 0; bit < (kind == diagonal_node ? 3U : kind == edge_node ? 2U : 8U); ++bit)
      for (const Slot& slot : used_[kind]) {
        const std::size_t first = turns_[kind].size();
        add_turns(tables, kind, bit, slot);
        if (turns_[kind].size() == first) continue;
        assert(count < most_turns);
        first_turn_[kind][count] = static_cast<std::uint16_t>(first);
        for (unsigned byte = 0; byte < 256; ++byte) {
          const auto has = [&](unsigned number) { return std::uint64_t{byte >> number & 1U} << count; };
          ending_in_[kind][slot.number / 8][byte] |= has(slot.number % 8);
          beginning_with_[kind][byte] |= has(bit);
        }
        ++count;
      }
  }
}

/// Adds all turns of a bit that end in a slot.
void LaneTables::add_turns(const DriveTables& tables, unsigned kind, unsigned bit, const Slot& slot) {
  const Turn turn = reversed(turn_of(bit, kind == diagonal_node, kind == edge_node));
  std::vector<TurnBefore>& turns = turns_[kind];
  bool first = true;
  for (const DrivenTurn& driven : tables.turns) {
    if (driven.turn != turn || driven.to != slot.lane) continue;
    if (!std::exchange(first, false)) turns.back().more = true;
    const int before = this->slot(begin_of(turn), driven.from);
    turns.push_back({static_cast<std::uint8_t>(slot.number), static_cast<std::uint8_t>(bit),
                     static_cast<std::uint8_t>(before), false, driven.time});
  }
}

}  // namespace labmouse::drive
