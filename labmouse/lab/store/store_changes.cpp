#include "labmouse/lab/store/store_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>

#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/system/file_lock.hpp"
#include "labmouse/lab/system/file_problems.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// So many conflicts are named; where there is one there are often many.
constexpr int named_conflicts = 10;

/// What the other store calls by its own numbers, by ours: temporary tables of pairs.
constexpr const char* add_what_contests_name = R"(
INSERT INTO main.worlds (text, name, conditions, unit) SELECT text, name, conditions, unit FROM part.worlds
  WHERE true ON CONFLICT DO NOTHING;
INSERT INTO main.mice (text, name, spec, parameters, about) SELECT text, name, spec, parameters, about FROM part.mice
  WHERE true ON CONFLICT DO NOTHING;
INSERT INTO main.mazes (text, name, width, height) SELECT text, name, width, height FROM part.mazes
  WHERE true ON CONFLICT DO NOTHING;
INSERT INTO main.builds (version, compiler, processor) SELECT version, compiler, processor FROM part.builds
  WHERE true ON CONFLICT DO NOTHING;
CREATE TEMP TABLE same_world AS SELECT theirs.id AS theirs, ours.id AS ours FROM part.worlds AS theirs
  JOIN main.worlds AS ours USING (text);
CREATE TEMP TABLE same_mouse AS SELECT theirs.id AS theirs, ours.id AS ours FROM part.mice AS theirs
  JOIN main.mice AS ours USING (text);
CREATE TEMP TABLE same_maze AS SELECT theirs.id AS theirs, ours.id AS ours FROM part.mazes AS theirs
  JOIN main.mazes AS ours USING (text);
CREATE TEMP TABLE same_build AS SELECT theirs.id AS theirs, ours.id AS ours FROM part.builds AS theirs
  JOIN main.builds AS ours USING (version, compiler, processor);
INSERT INTO main.bounds (world, maze, bound) SELECT same_world.ours, same_maze.ours, bound FROM part.bounds AS theirs
  JOIN same_world ON same_world.theirs = theirs.world JOIN same_maze ON same_maze.theirs = theirs.maze
  WHERE true ON CONFLICT DO NOTHING;
CREATE TEMP TABLE theirs AS SELECT c.id AS id, same_world.ours AS world, same_mouse.ours AS mouse, same_maze.ours AS maze,
  c.seed AS seed, same_build.ours AS build FROM part.contests AS c
  JOIN same_world ON same_world.theirs = c.world JOIN same_mouse ON same_mouse.theirs = c.mouse
  JOIN same_maze ON same_maze.theirs = c.maze JOIN same_build ON same_build.theirs = c.build;
CREATE TEMP TABLE both AS SELECT theirs.id AS theirs, ours.id AS ours FROM theirs
  JOIN main.contests AS ours USING (world, mouse, maze, seed);
)";

constexpr const char* find_conflicts = R"(
SELECT worlds.name, mice.name, mazes.name, a.seed, a.outcome, b.outcome, a.score, b.score
  FROM both JOIN main.contests AS a ON a.id = both.ours JOIN part.contests AS b ON b.id = both.theirs
  JOIN main.worlds ON worlds.id = a.world JOIN main.mice ON mice.id = a.mouse JOIN main.mazes ON mazes.id = a.maze
 WHERE a.outcome <> b.outcome OR a.score IS NOT b.score OR a.counted IS NOT b.counted OR a.ratio IS NOT b.ratio
    OR a.figures <> b.figures OR a.never_started <> b.never_started
 ORDER BY a.id)";

constexpr const char* add_contests = R"(
INSERT INTO main.contests (world, mouse, maze, seed, run, race_seed, outcome, outcome_order, never_started, score, counted,
                           ratio, fields, figures, build, time)
  SELECT theirs.world, theirs.mouse, theirs.maze, theirs.seed, run, race_seed, outcome, outcome_order, never_started, score,
         counted, ratio, fields, figures, theirs.build, time
    FROM theirs JOIN part.contests AS c ON c.id = theirs.id
   WHERE theirs.id NOT IN (SELECT theirs FROM both) ORDER BY theirs.id;
)";

constexpr const char* add_timings = R"(
INSERT INTO main.timings (contest, figures)
  SELECT ours.id, t.figures FROM theirs JOIN part.timings AS t ON t.contest = theirs.id
    JOIN main.contests AS ours ON ours.world = theirs.world AND ours.mouse = theirs.mouse AND ours.maze = theirs.maze
     AND ours.seed = theirs.seed
   WHERE true ON CONFLICT DO NOTHING;
)";

constexpr const char* tidy_up = R"(
DROP TABLE both; DROP TABLE theirs; DROP TABLE same_world; DROP TABLE same_mouse; DROP TABLE same_maze; DROP TABLE same_build;
)";

std::string score_words(const std::optional<double>& score) { return score ? fmt::format(" ({})", *score) : ""; }

/// Names the first conflicts between the attached store and ours.
void name_conflicts(Database& database, const std::string& path, Merge& merge) {
  Statement rows = database.prepare(find_conflicts);
  int more = 0;
  while (rows.next()) {
    if (merge.conflicts.size() >= named_conflicts && ++more > 0) continue;
    merge.conflicts.push_back(
        shown(fmt::format("{}: {} in {} with seed {}, world {}: {}{} there, and {}{} otherwise", path, rows.text(1),
                          rows.text(2), rows.whole(3), rows.text(0), rows.text(5), score_words(rows.real(7)),
                          rows.text(4), score_words(rows.real(6)))));
  }
  if (more > 0) merge.conflicts.push_back(fmt::format("and {} more in {}", more, shown(path)));
}

/// Adds one store in a transaction; not at all where there is a conflict, which names the store `called`.
void merge_one(Database& database, const std::string& path, const std::string& called, Merge& merge) {
  if (!merge.conflicts.empty()) return;
  database.prepare("ATTACH ?1 AS part").bind(1, path).run();
  database.run("BEGIN IMMEDIATE");
  database.run(add_what_contests_name);
  name_conflicts(database, called, merge);
  if (!merge.conflicts.empty()) {
    database.roll_back();
    return;
  }
  database.run(add_contests);
  merge.added += database.changes();
  merge.equal += database.number("SELECT count(*) FROM both");
  database.run(add_timings);
  database.run(tidy_up);
  database.run("COMMIT; DETACH part");
}

/// Why a store cannot be read by a merge; empty where it can.
std::string refuse(const std::string& path, const std::string& target) {
  std::error_code none;
  if (fs::equivalent(path, target, none)) return error_line(path, "is the target of the merge itself");
  return error_line(path, open_store(path, Database::Access::read).error());
}

/// Gives a store its name, unless a store has that; whether it is done, which a merge that failed is, too. Another
/// program may make the target at this moment: it must not be lost, so the name is given only where there is none.
bool becomes(const std::string& beside, const std::string& target, Merge& merge) {
  std::error_code error;
  if (fs::exists(target, error)) return false;
  fs::create_hard_link(beside, target, error);
  if (error == std::errc::file_exists) return false;
  // Some file systems have no second names.
  if (error) fs::rename(beside, target, error);
  if (error) merge.error = error_line(target, "cannot be written: " + cause_of(error.value()));
  return true;
}

/// Where a merge did not go well, nothing was changed.
Merge as_it_ended(Merge merge) {
  if (!merge.good()) merge.added = merge.equal = 0;
  return merge;
}

/// A file beside the target in which a merge puts its parts together, for as long as this lives. One that was killed
/// left its own: nobody has locked that any more, so the next merge into the target removes it.
class FileBeside {
 public:
  explicit FileBeside(const std::string& target) : begin_(target + ".merging-") {
    for (int number = 1; path_.empty() && error_ == 0; ++number)
      if (auto file = taken(std::to_string(number), error_)) {
        path_ = begin_ + std::to_string(number);
        lock_.emplace(std::move(*file));
      }
    remove_leftovers(fs::path(target));
  }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;
  ~FileBeside() {
    // Before it is unlocked, so that nobody has locked it when it goes.
    if (lock_) remove(path_);
  }

  /// Why there is none; empty where there is one.
  std::string error() const { return error_ == 0 ? "" : "cannot be written: " + cause_of(error_); }
  const std::string& path() const { return path_; }

 private:
  static constexpr const char* lock_ending = "-lock";

  /// Locks the file of that number and empties it; nothing where another merge has it, or where it cannot be made.
  std::optional<Descriptor> taken(const std::string& number, int& error) const {
    Descriptor file = locked_file(begin_ + number + lock_ending, error);
    if (error == EWOULDBLOCK)
      error = 0;
    else if (error == 0) {
      remove_store(begin_ + number);
      return file;
    }
    return std::nullopt;
  }

  /// Our own is locked, as those of all others at work are.
  void remove_leftovers(const fs::path& target) const {
    const std::string begin = target.filename().string() + ".merging-";
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::vector<std::string> numbers;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      if (!name.starts_with(begin)) continue;
      const std::string rest = name.substr(begin.size()), number = rest.substr(0, rest.find('-'));
      const bool is_number = !number.empty() && std::all_of(number.begin(), number.end(),
                                                            [](char letter) { return letter >= '0' && letter <= '9'; });
      if (is_number) numbers.push_back(number);
    }
    for (const std::string& number : numbers) {
      int unknown = 0;
      if (const auto lock = taken(number, unknown)) remove(begin_ + number);
    }
  }

  static void remove_store(const std::string& path) {
    std::error_code unknown;
    for (const char* ending : {"", "-wal", "-shm"}) fs::remove(path + ending, unknown);
  }
  static void remove(const std::string& path) {
    std::error_code unknown;
    remove_store(path);
    fs::remove(path + lock_ending, unknown);
  }

  std::string begin_, path_;
  std::optional<Descriptor> lock_;
  int error_ = 0;
};

}  // namespace

Merge merge_stores(const std::vector<std::string>& paths, const std::string& target) {
  Merge merge;
  for (const std::string& path : paths)
    if (merge.error = refuse(path, target); !merge.error.empty()) return merge;
  // The parts are put together beside the target, which then changes in one transaction, or by a new name.
  const FileBeside beside(target);
  if (merge.error = error_line(target, beside.error()); !merge.error.empty()) return merge;
  {
    Database database = open_store(beside.path(), Database::Access::create);
    for (const std::string& path : paths) merge_one(database, path, path, merge);
    if (merge.error.empty()) merge.error = error_line(beside.path(), database.error());
  }
  if (!merge.good() || becomes(beside.path(), target, merge)) return as_it_ended(std::move(merge));
  merge.added = merge.equal = 0;
  Database database = open_store(target, Database::Access::write);
  merge_one(database, beside.path(), target, merge);
  if (merge.error.empty()) merge.error = error_line(target, database.error());
  return as_it_ended(std::move(merge));
}

Forgotten forget(const std::string& path, const StoreFilter& filter) {
  Forgotten forgotten;
  Database database = open_store(path, Database::Access::write);
  database.run("BEGIN IMMEDIATE");
  database.run("CREATE TEMP TABLE gone AS SELECT id FROM results" + condition_of(filter));
  database.run("DELETE FROM timings WHERE contest IN (SELECT id FROM gone)");
  database.run("DELETE FROM contests WHERE id IN (SELECT id FROM gone)");
  forgotten.contests = database.changes();
  database.run(R"(
    DELETE FROM bounds WHERE NOT EXISTS (
      SELECT 1 FROM contests WHERE contests.world = bounds.world AND contests.maze = bounds.maze);
    DELETE FROM worlds WHERE id NOT IN (SELECT world FROM contests);
    DELETE FROM mice WHERE id NOT IN (SELECT mouse FROM contests);
    DELETE FROM mazes WHERE id NOT IN (SELECT maze FROM contests);
    DELETE FROM builds WHERE id NOT IN (SELECT build FROM contests);
    COMMIT)");
  forgotten.error = error_line(path, database.error());
  if (!forgotten.error.empty()) forgotten.contests = 0;
  return forgotten;
}

}  // namespace labmouse
