// The contests of a season: all mice in the practice mazes and in those of the examination.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "labmouse/lab/league/league.hpp"
#include "labmouse/lab/league/ranking.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// A race with its records.
struct RecordedRace {
  Race race;                         ///< without paths and times by the clock, so that equal seasons are equal
  std::vector<std::string> records;  ///< of each result; empty where there is none
};

struct SeasonRaces {
  RecordedRace practice, examination;
  bool stopped = false;  ///< before all contests were done
  int not_judged = 0;    ///< contests that have no result because the machine was too busy
  std::string error;     ///< why records cannot be written or read, as a line for the user
};

struct SeasonOrder {
  std::string secret;  ///< the seed of the examination
  int jobs = 0;        ///< threads; 0 takes as many as there are processors. Results do not depend on it.
  Shard shard = {};    ///< only these contests of each race are run
  /// Where contests are taken from and kept. Those with a record are not run again.
  std::shared_ptr<ContestStore> store;
  std::string records = {};                 ///< the folder of records; empty for that of the league
  const std::atomic<bool>* stop = nullptr;  ///< once it is true, no other contest begins
  /// Called after each contest with how many there are, and whether it ran: it does not where the store has it.
  std::function<void(std::size_t, bool)> advanced = {};
};

/// Runs one contest of each mouse in each maze.
SeasonRaces run_season(const League& league, const SeasonOrder& order);

/// How the mice did in the examination, in the order of the race's mice.
std::vector<MouseShares> examination_shares(const Race& examination);

}  // namespace labmouse
