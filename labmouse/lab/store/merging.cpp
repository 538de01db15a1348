#include "labmouse/lab/store/merging.hpp"

#include <fmt/format.h>

#include <optional>

#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Number of conflicts that are listed.
constexpr std::size_t named_conflicts = 10;

/// The contests of the other store.
constexpr const char* their_contests =
    "SELECT world, mouse, maze, seed, build, run, race_seed, outcome, outcome_order, never_started, score, counted, "
    "ratio, fields, contests.figures AS figures, time, timings.figures AS timings "
    "FROM contests LEFT JOIN timings ON timings.contest = contests.id ORDER BY contests.id";
/// The columns that are copied unchanged, in the order of add_contest_.
constexpr std::array copied_columns = {"run",     "race_seed", "outcome", "outcome_order", "never_started", "score",
                                       "counted", "ratio",     "fields",  "figures",       "time"};
/// The columns that contests with the same results have in common besides the outcome, in the order of find_.
constexpr std::array compared_columns = {"never_started", "score", "counted", "ratio", "figures"};

/// Our id for a row of the other store, which is damaged if it refers to a missing row.
std::int64_t number_of(const std::map<std::int64_t, std::int64_t>& numbers, std::int64_t theirs, Database& database) {
  const auto found = numbers.find(theirs);
  if (found != numbers.end()) return found->second;
  database.fail("is damaged: a contest or a bound belongs to nothing that is there");
  return 0;
}

std::string score_words(const std::optional<double>& score) { return score ? fmt::format(" ({})", *score) : ""; }

}  // namespace

Merging::Merging(Database& ours)
    : ours_(ours),
      add_bound_(ours.prepare("INSERT INTO bounds (world, maze, bound) VALUES (?1, ?2, ?3) ON CONFLICT DO NOTHING")),
      add_contest_(ours.prepare(
          "INSERT INTO contests (world, mouse, maze, seed, build, run, race_seed, outcome, outcome_order, "
          "never_started, score, counted, ratio, fields, figures, time) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, "
          "?10, ?11, ?12, ?13, ?14, ?15, ?16) ON CONFLICT DO NOTHING")),
      add_timing_(ours.prepare("INSERT INTO timings (contest, figures) VALUES (?1, ?2) ON CONFLICT DO NOTHING")),
      find_(ours.prepare(
          "SELECT id, outcome, score, never_started IS ?5 AND score IS ?6 AND counted IS ?7 AND ratio IS ?8 AND "
          "figures IS ?9 AS same FROM contests WHERE world = ?1 AND mouse = ?2 AND maze = ?3 AND seed = ?4")),
      name_(ours.prepare("SELECT worlds.name AS world, mice.name AS mouse, mazes.name AS maze FROM worlds, mice, mazes "
                         "WHERE worlds.id = ?1 AND mice.id = ?2 AND mazes.id = ?3")) {}

void Merging::add(Database& theirs, const std::string& path, Merge& merge) {
  theirs.run("BEGIN");
  worlds_ = add_named(theirs, "worlds", "text", ", name, conditions, unit");
  mice_ = add_named(theirs, "mice", "text", ", name, spec, parameters, about");
  mazes_ = add_named(theirs, "mazes", "text", ", name, width, height");
  builds_ = add_named(theirs, "builds", "version, compiler, processor", "");
  add_bounds(theirs);
  add_contests(theirs, path, merge);
  theirs.run("COMMIT");
}

/// Adds the rows of a table that are new by their key. Returns our ids of all of them.
Merging::Numbers Merging::add_named(Database& theirs, const char* table, const std::string& key,
                                    const std::string& rest) {
  const std::string columns = key + rest;
  std::string places = "?1";
  int count = 1;
  for (const char letter : columns)
    if (letter == ',') places += fmt::format(", ?{}", ++count);
  Statement read = theirs.prepare(fmt::format("SELECT id, {} FROM {}", columns, table));
  Statement add =
      ours_.prepare(fmt::format("INSERT INTO {} ({}) VALUES ({}) ON CONFLICT DO NOTHING", table, columns, places));
  Statement find = ours_.prepare(
      fmt::format("SELECT id FROM {} WHERE ({}) = ({})", table, key, rest.empty() ? places : std::string("?1")));
  Numbers numbers;
  while (read.next()) {
    for (int place = 1; place <= count; ++place) {
      add.bind(place, read, place);
      if (rest.empty() || place == 1) find.bind(place, read, place);
    }
    add.run();
    while (find.next()) numbers[read.whole("id")] = find.whole("id");
  }
  return numbers;
}

void Merging::add_bounds(Database& theirs) {
  Statement read = theirs.prepare("SELECT world, maze, bound FROM bounds");
  while (read.next()) {
    const std::int64_t world = number_of(worlds_, read.whole("world"), theirs);
    add_bound_.bind(1, world).bind(2, number_of(mazes_, read.whole("maze"), theirs)).bind(3, read, "bound").run();
  }
}

void Merging::add_contests(Database& theirs, const std::string& path, Merge& merge) {
  Statement row = theirs.prepare(their_contests);
  while (row.next()) {
    const std::array<std::int64_t, 4> place = {number_of(worlds_, row.whole("world"), theirs),
                                               number_of(mice_, row.whole("mouse"), theirs),
                                               number_of(mazes_, row.whole("maze"), theirs), row.whole("seed")};
    for (int i = 0; i < 4; ++i) add_contest_.bind(i + 1, place[static_cast<unsigned>(i)]);
    add_contest_.bind(5, number_of(builds_, row.whole("build"), theirs));
    int parameter = 6;
    for (const char* column : copied_columns) add_contest_.bind(parameter++, row, column);
    add_contest_.run();
    if (!ours_.good() || !theirs.good()) return;
    if (ours_.changes() == 0) {
      compare(row, place, path, merge);
      continue;
    }
    ++merge.added;
    if (!row.is_null("timings")) add_timing_.bind(1, ours_.last_row()).bind(2, row, "timings").run();
  }
  if (unnamed_ > 0) merge.conflicts.push_back(fmt::format("and {} more in {}", unnamed_, shown(path)));
}

/// Compares a contest with the one of the same key in our store.
void Merging::compare(const Statement& row, const std::array<std::int64_t, 4>& place, const std::string& path,
                      Merge& merge) {
  for (int i = 0; i < 4; ++i) find_.bind(i + 1, place[static_cast<unsigned>(i)]);
  int parameter = 5;
  for (const char* column : compared_columns) find_.bind(parameter++, row, column);
  while (find_.next()) {
    // An earlier version may have written the outcome under a former name.
    if (find_.whole("same") != 0 && today_value(find_.text("outcome")) == today_value(row.text("outcome"))) {
      ++merge.equal;
      if (!row.is_null("timings")) add_timing_.bind(1, find_.whole("id")).bind(2, row, "timings").run();
    } else if (merge.conflicts.size() < named_conflicts) {
      merge.conflicts.push_back(conflict(row, place, path));
    } else {
      ++unnamed_;
    }
  }
}

std::string Merging::conflict(const Statement& row, const std::array<std::int64_t, 4>& place, const std::string& path) {
  for (int i = 0; i < 3; ++i) name_.bind(i + 1, place[static_cast<unsigned>(i)]);
  std::string line;
  while (name_.next())
    line =
        shown(fmt::format("{}: {} in {} with seed {}, world {}: {}{} there, and {}{} otherwise", path,
                          name_.text("mouse"), name_.text("maze"), place[3], name_.text("world"), row.text("outcome"),
                          score_words(row.real("score")), find_.text("outcome"), score_words(find_.real("score"))));
  return line;
}

}  // namespace labmouse
