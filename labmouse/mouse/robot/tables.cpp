#include "labmouse/mouse/robot/tables.hpp"

#include <algorithm>
#include <cmath>

namespace labmouse {
namespace {

/// FNV-1a over whole numbers, lengths as whole micrometres: the same on every platform.
class TableHash {
 public:
  void add(std::int64_t number) {
    const auto bits = static_cast<std::uint64_t>(number);
    for (unsigned shift = 0; shift < 64; shift += 8) hash_ = (hash_ ^ (bits >> shift & 0xFFU)) * 0x100000001B3U;
  }
  void add_length(double millimetres) { add(static_cast<std::int64_t>(std::floor(millimetres * 1000.0 + 0.5))); }
  void add(const std::vector<DriveTime>& times) {
    add(static_cast<std::int64_t>(times.size()));
    for (const DriveTime time : times) add(time < no_time ? std::int64_t{time} : std::int64_t{-1});
  }
  void add(const StraightTimes& straights) {
    add(static_cast<std::int64_t>(straights.count()));
    for (const Lane& lane : straights.lanes) {
      add_length(lane.speed);
      add_length(lane.lead);
    }
    add(straights.between);
  }
  void add(const DrivenTurn& turn) {
    for (const int number : {static_cast<int>(turn.turn), int{turn.from}, int{turn.to}, int{turn.time}}) add(number);
    add_length(turn.speed);
    // Left out if it is the same, so that robots without grip keep the hashes of earlier versions.
    if (turn.end_speed != turn.speed) add_length(turn.end_speed);
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

}  // namespace

DriveTime DriveTables::shortest_turn() const {
  DriveTime shortest = no_time;
  for (const DrivenTurn& turn : turns) shortest = std::min(shortest, turn.time);
  return shortest;
}

std::uint64_t hash_of(const DriveTables& tables) {
  TableHash hash;
  hash.add_length(tables.cell);
  hash.add(tables.along);
  hash.add(tables.diagonal);
  for (const auto* times : {&tables.start, &tables.finish, &tables.whole}) hash.add(*times);
  hash.add(static_cast<std::int64_t>(tables.turns.size()));
  for (const DrivenTurn& turn : tables.turns) hash.add(turn);
  return hash.value();
}

}  // namespace labmouse
