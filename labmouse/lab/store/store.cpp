#include "labmouse/lab/store/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <new>
#include <tuple>

#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/system/version.hpp"

namespace labmouse {
namespace {

/// Longest wait of a contest before it is written; a power failure loses at most these contests.
constexpr std::chrono::milliseconds longest_wait{250};
/// Number of contests that are written at once; a full batch is written without waiting.
constexpr std::size_t full_batch = 4096;
/// Limit of waiting contests; beyond it, keep() blocks.
constexpr std::size_t most_waiting = 65536;

/// Finds and caches the id of the row with a text; 0 where there is none.
class Ids {
 public:
  Ids(Database& database, const std::string& table)
      : find_(database.prepare(fmt::format("SELECT id FROM {} WHERE text = ?1", table))) {}

  std::int64_t of(const std::string& text) {
    const auto [place, is_new] = known_.try_emplace(text, 0);
    if (!is_new) return place->second;
    find_.bind(1, text);
    while (find_.next()) place->second = find_.whole("id");
    return place->second;
  }

 private:
  Statement find_;
  std::map<std::string, std::int64_t> known_;
};

/// Adds rows to a store inside of a transaction.
class Writing {
 public:
  explicit Writing(Database& database)
      : database_(database),
        add_world_(database.prepare("INSERT INTO worlds (text, name, conditions, unit) VALUES (?1, ?2, ?3, ?4) "
                                    "ON CONFLICT DO UPDATE SET name = excluded.name WHERE name <> excluded.name")),
        add_mouse_(database.prepare("INSERT INTO mice (text, name, spec, parameters, about) "
                                    "VALUES (?1, ?2, ?3, ?4, ?5) ON CONFLICT DO NOTHING")),
        add_maze_(database.prepare("INSERT INTO mazes (text, name, width, height) VALUES (?1, ?2, ?3, ?4) "
                                   "ON CONFLICT DO NOTHING")),
        add_bound_(database.prepare("INSERT INTO bounds (world, maze, bound) VALUES (?1, ?2, ?3) "
                                    "ON CONFLICT DO NOTHING")),
        add_contest_(database.prepare(
            "INSERT INTO contests (world, mouse, maze, seed, run, race_seed, outcome, outcome_order, never_started, "
            "score, counted, ratio, fields, figures, build, time) "
            "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16) ON CONFLICT DO NOTHING")),
        add_timing_(database.prepare("INSERT INTO timings (contest, figures) VALUES (?1, ?2)")),
        worlds_(database, "worlds"),
        mice_(database, "mice"),
        mazes_(database, "mazes") {
    Statement add = database.prepare(
        "INSERT INTO builds (version, compiler, processor) VALUES (?1, ?2, ?3) ON CONFLICT DO NOTHING");
    Statement find = database.prepare("SELECT id FROM builds WHERE version = ?1 AND compiler = ?2 AND processor = ?3");
    for (Statement* statement : {&add, &find}) statement->bind(1, version()).bind(2, compiler()).bind(3, processor());
    add.run();
    while (find.next()) build_ = find.whole("id");
  }

  /// Adds a contest. Returns whether it was new.
  bool add(const ContestRow& row) {
    const Place place = place_of(row);
    const ContestResult& result = row.result;
    add_contest_.bind(1, place.world).bind(2, place.mouse).bind(3, place.maze);
    add_contest_.bind(4, static_cast<std::int64_t>(result.seed)).bind(5, std::int64_t{result.run});
    add_contest_.bind(6, row.race->race_seed).bind(7, result.outcome).bind(8, std::int64_t{result.outcome_order});
    add_contest_.bind(9, result.never_started).bind(10, result.score).bind(11, result.counted).bind(12, result.ratio);
    add_contest_.bind(13, row.fields).bind(14, row.figures).bind(15, build_).bind(16, row.time);
    add_contest_.run();
    if (!database_.good() || database_.changes() == 0) return false;
    if (!row.timings.empty()) add_timing_.bind(1, database_.last_row()).bind(2, row.timings).run();
    return database_.good();
  }

 private:
  struct Place {
    std::int64_t world = 0, mouse = 0, maze = 0;
  };

  /// The ids of the row's world, mouse and maze, which are added if new. They are cached for one batch only, because
  /// another program may change the store between batches.
  Place place_of(const ContestRow& row) {
    const RaceRows& race = *row.race;
    const auto [known, is_new] = places_.try_emplace({row.race.get(), row.mouse, row.maze});
    if (!is_new) return known->second;
    const RaceRows::Mouse& mouse = race.mice[row.mouse];
    const RaceRows::MazeRow& maze = race.mazes[row.maze];
    add_world_.bind(1, race.world_key).bind(2, race.world).bind(3, race.conditions).bind(4, race.unit).run();
    add_mouse_.bind(1, mouse.key).bind(2, mouse.name).bind(3, mouse.spec).bind(4, mouse.parameters);
    add_mouse_.bind(5, mouse.about).run();
    add_maze_.bind(1, maze.key).bind(2, maze.name).bind(3, std::int64_t{maze.size.width});
    add_maze_.bind(4, std::int64_t{maze.size.height}).run();
    Place& place = known->second;
    place = {worlds_.of(race.world_key), mice_.of(mouse.key), mazes_.of(maze.key)};
    add_bound_.bind(1, place.world).bind(2, place.maze).bind(3, maze.bound).run();
    return place;
  }

  Database& database_;
  Statement add_world_, add_mouse_, add_maze_, add_bound_, add_contest_, add_timing_;
  Ids worlds_, mice_, mazes_;
  std::map<std::tuple<const RaceRows*, std::size_t, std::size_t>, Place> places_;
  std::int64_t build_ = 0;
};

}  // namespace

Store::Store(const std::string& path, Database::Access access)
    : path_(path),
      writing_(open_checked_store(path, access)),
      reading_(open_store(writing_.good() ? path : "", Database::Access::read)) {
  failed_ = !writing_.good() || !reading_.good();
  if (!failed_) writer_ = std::thread([this] { write_batches(); });
}

Store::~Store() {
  if (!writer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  work_.notify_all();
  writer_.join();
}

void Store::recall(Race& race, const std::function<bool(const ContestResult&)>& wanted) {
  if (failed_) return;
  rows_ = std::make_shared<const RaceRows>(rows_of(race));
  reading_.run("BEGIN");
  Ids worlds(reading_, "worlds"), mice(reading_, "mice"), mazes(reading_, "mazes");
  Statement find =
      reading_.prepare(fmt::format("SELECT {} FROM contests LEFT JOIN timings ON timings.contest = contests.id "
                                   "WHERE world = ?1 AND mouse = ?2 AND maze = ?3 AND seed = ?4",
                                   result_columns));
  for (ContestResult& contest : race.results) {
    if (!wanted(contest)) continue;
    const std::int64_t mouse = mice.of(rows_->mice[contest.mouse].key);
    if (mouse == 0) continue;
    find.bind(1, worlds.of(rows_->world_key)).bind(2, mouse).bind(3, mazes.of(rows_->mazes[contest.maze].key));
    find.bind(4, static_cast<std::int64_t>(contest.seed));
    while (find.next()) {
      const int run = contest.run;
      if (fill_in(find, race.world(), contest)) ++recalled_;
      // `run` is the number of the contest. The stored one may be of a race with another name of the maze.
      contest.run = run;
    }
  }
  reading_.run("COMMIT");
  if (!reading_.good()) failed_ = true;
}

void Store::keep(const Race& race, const ContestResult& contest) {
  if (rows_->mice[contest.mouse].key.empty()) {
    ++passed_by_;
    return;
  }
  ContestRow row = row_of(rows_, race, contest);
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return waiting_.size() < most_waiting || failed_; });
  waiting_.push_back(std::move(row));
  const bool tell = waiting_.size() == 1 || waiting_.size() == full_batch;
  lock.unlock();
  if (tell) work_.notify_one();
}

void Store::write_batches() {
  std::vector<ContestRow> rows;
  std::unique_lock lock(mutex_);
  while (true) {
    work_.wait(lock, [&] { return closing_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    work_.wait_for(lock, longest_wait, [&] { return closing_ || hurry_ || waiting_.size() >= full_batch; });
    rows.swap(waiting_);
    writing_now_ = true;
    lock.unlock();
    // In batches, so that a full disk keeps those that fitted.
    for (std::size_t begin = 0; begin < rows.size() && !failed_; begin += full_batch)
      write_or_fail(std::span(rows).subspan(begin, std::min(full_batch, rows.size() - begin)));
    rows.clear();
    lock.lock();
    writing_now_ = false;
    done_.notify_all();
  }
}

/// Catches exceptions, because one would end the program from this thread.
void Store::write_or_fail(std::span<const ContestRow> rows) {
  try {
    write(rows);
  } catch (const std::bad_alloc&) {
    writing_.roll_back();
    writing_.fail("cannot be written: out of memory");
    failed_ = true;
  }
}

void Store::write(std::span<const ContestRow> rows) {
  std::size_t added = 0;
  writing_.run("BEGIN IMMEDIATE");
  {
    Writing batch(writing_);
    for (const ContestRow& row : rows) added += batch.add(row) ? 1 : 0;
  }
  writing_.run("COMMIT");
  if (writing_.good()) {
    added_ += added;
  } else {
    writing_.roll_back();
    failed_ = true;
  }
}

std::string Store::finish() {
  std::unique_lock lock(mutex_);
  hurry_ = true;
  work_.notify_one();
  done_.wait(lock, [&] { return waiting_.empty() && !writing_now_; });
  hurry_ = false;
  const std::string& error = writing_.good() ? reading_.error() : writing_.error();
  return error_line(path_, error);
}

}  // namespace labmouse
