// A contest of a race as a row of a store, and back.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/store/database.hpp"

namespace labmouse {

/// What the rows of one race share: who raced where, each as its key and what is printed of it.
struct RaceRows {
  struct Mouse {
    std::string key;  ///< empty: its contests are not kept
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

/// A race in which nothing has to be held yet. Reads the files of external mice.
RaceRows rows_of(const Race& race);

/// A row, with its mouse and maze by their places in the race.
struct ContestRow {
  std::shared_ptr<const RaceRows> race;
  std::size_t mouse = 0, maze = 0;
  ContestResult result;  ///< without its figures
  std::string fields, figures, timings;
  std::int64_t time = 0;  ///< seconds since 1970
};

/// The row of a contest that was held. Its timings stand in a list of their own, and are 0 among the figures and absent
/// from the fields.
ContestRow row_of(std::shared_ptr<const RaceRows> rows, const Race& race, const ContestResult& result);

/// The columns of contests and timings that fill_in reads.
inline constexpr const char* result_columns =
    "run, outcome, outcome_order, never_started, score, counted, ratio, contests.figures AS figures, "
    "timings.figures AS timings, race_seed";

/// Fills in what a row with these columns says; false where its figures or its seed cannot be read. It is done then.
bool fill_in(const Statement& row, const World& world, ContestResult& result);

/// What a store tells of a mouse beside its name, as JSON, and back.
std::string about_text(const Contestant& mouse);
void read_about(std::string_view about, Contestant& mouse);
std::string parameters_text(const World& world, const Contestant& mouse);

}  // namespace labmouse
