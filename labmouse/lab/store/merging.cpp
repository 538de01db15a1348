#include "labmouse/lab/store/merging.hpp"

#include <fmt/format.h>

#include <optional>

#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Number of conflicts that are listed.
constexpr std::size_t named_conflicts = 10;

/// The contests of the other store: four row ids, the seed, the timings, and then the columns that are copied
/// unchanged.
constexpr const char* their_contests =
    "SELECT world, mouse, maze, build, seed, timings.figures, run, race_seed, outcome, outcome_order, never_started, "
    "score, counted, ratio, fields, contests.figures, time "
    "FROM contests LEFT JOIN timings ON timings.contest = contests.id ORDER BY contests.id";
/// Column numbers of that query.
enum StoredColumn : int {
  seed_column = 4,
  clock_figures_column = 5,
  first_copied_column = 6,
  outcome_column = 8,
  never_started_column = 10,
  score_column = 11,
  counted_column = 12,
  ratio_column = 13,
  figures_column = 15,
  columns_count = 17,
};

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
          "figures IS ?9 FROM contests WHERE world = ?1 AND mouse = ?2 AND maze = ?3 AND seed = ?4")),
      name_(ours.prepare("SELECT worlds.name, mice.name, mazes.name FROM worlds, mice, mazes "
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
    while (find.next()) numbers[read.whole(0)] = find.whole(0);
  }
  return numbers;
}

void Merging::add_bounds(Database& theirs) {
  Statement read = theirs.prepare("SELECT world, maze, bound FROM bounds");
  while (read.next()) {
    const std::int64_t world = number_of(worlds_, read.whole(0), theirs);
    add_bound_.bind(1, world).bind(2, number_of(mazes_, read.whole(1), theirs)).bind(3, read, 2).run();
  }
}

void Merging::add_contests(Database& theirs, const std::string& path, Merge& merge) {
  Statement row = theirs.prepare(their_contests);
  while (row.next()) {
    const std::array<std::int64_t, 4> place = {number_of(worlds_, row.whole(0), theirs),
                                               number_of(mice_, row.whole(1), theirs),
                                               number_of(mazes_, row.whole(2), theirs), row.whole(seed_column)};
    for (int i = 0; i < 4; ++i) add_contest_.bind(i + 1, place[static_cast<unsigned>(i)]);
    add_contest_.bind(5, number_of(builds_, row.whole(3), theirs));
    for (int column = first_copied_column; column < columns_count; ++column) add_contest_.bind(column, row, column);
    add_contest_.run();
    if (!ours_.good() || !theirs.good()) return;
    if (ours_.changes() == 0) {
      compare(row, place, path, merge);
      continue;
    }
    ++merge.added;
    if (!row.is_null(clock_figures_column))
      add_timing_.bind(1, ours_.last_row()).bind(2, row, clock_figures_column).run();
  }
  if (unnamed_ > 0) merge.conflicts.push_back(fmt::format("and {} more in {}", unnamed_, shown(path)));
}

/// Compares a contest with the one of the same key in our store.
void Merging::compare(const Statement& row, const std::array<std::int64_t, 4>& place, const std::string& path,
                      Merge& merge) {
  for (int i = 0; i < 4; ++i) find_.bind(i + 1, place[static_cast<unsigned>(i)]);
  constexpr std::array<int, 5> results = {never_started_column, score_column, counted_column, ratio_column,
                                          figures_column};
  for (int i = 0; i < 5; ++i) find_.bind(i + 5, row, results[static_cast<unsigned>(i)]);
  while (find_.next()) {
    // An earlier version may have written the outcome under a former name.
    if (find_.whole(3) != 0 && today_value(find_.text(1)) == today_value(row.text(outcome_column))) {
      ++merge.equal;
      if (!row.is_null(clock_figures_column))
        add_timing_.bind(1, find_.whole(0)).bind(2, row, clock_figures_column).run();
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
    line = shown(fmt::format("{}: {} in {} with seed {}, world {}: {}{} there, and {}{} otherwise", path, name_.text(1),
                             name_.text(2), place[3], name_.text(0), row.text(outcome_column),
                             score_words(row.real(score_column)), find_.text(1), score_words(find_.real(2))));
  return line;
}

}  // namespace labmouse
