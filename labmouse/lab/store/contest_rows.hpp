// Converts contests of a race to rows of a store and back.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/store/database.hpp"

namespace labmouse {

/// The part that all rows of one race share: its world, mice and mazes with their keys and printed texts.
struct RaceRows {
  struct Mouse {
    std::string key;  ///< empty: its contests are not stored
    std::string name, spec, parameters, about;
  };
  struct MazeRow {
    std::string key, name;
    Size size;
    std::optional<double> bound;
  };
  std::string world_key, world, conditions, unit, race_seed;
  std::vector<Mouse> mice;
  std::vector<MazeRow> mazes;
};

/// The shared part of the rows of a race. Reads the files of external mice. No contest has to be run.
RaceRows rows_of(const Race& race);

/// A row of the table of contests; `mouse` and `maze` are positions in the race.
struct ContestRow {
  std::shared_ptr<const RaceRows> race;
  std::size_t mouse = 0, maze = 0;
  ContestResult result;  ///< without its figures
  std::string fields, figures, timings;
  std::int64_t time = 0;  ///< seconds since 1970
};

/// The row of a contest that was run. Its timings are in `timings`; they are 0 in `figures` and missing in `fields`.
ContestRow row_of(std::shared_ptr<const RaceRows> rows, const Race& race, const ContestResult& result);

/// The columns of contests and timings that fill_in reads.
inline constexpr const char* result_columns =
    "run, outcome, outcome_order, never_started, score, counted, ratio, contests.figures AS figures, "
    "timings.figures AS timings, race_seed";

/// Fills in the result from a row with these columns and marks it as done. Returns false where its figures or its seed
/// cannot be read.
bool fill_in(const Statement& row, const World& world, ContestResult& result);

/// The stored properties of a mouse besides its name, as JSON.
std::string about_text(const Contestant& mouse);
void read_about(std::string_view about, Contestant& mouse);
std::string parameters_text(const World& world, const Contestant& mouse);

}  // namespace labmouse
