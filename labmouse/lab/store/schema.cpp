#include "labmouse/lab/store/schema.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>

#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// "LMst" in the file's header, SQLite's application id: tools that name file types can use it.
constexpr std::int64_t application = 0x4C4D7374;

constexpr const char* first_version = R"(
CREATE TABLE worlds (
  id INTEGER PRIMARY KEY,
  text TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  conditions TEXT NOT NULL,
  unit TEXT NOT NULL);
CREATE TABLE mice (
  id INTEGER PRIMARY KEY,
  text TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  spec TEXT NOT NULL,
  parameters TEXT NOT NULL,
  about TEXT NOT NULL);
CREATE TABLE mazes (
  id INTEGER PRIMARY KEY,
  text TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  width INTEGER NOT NULL,
  height INTEGER NOT NULL);
CREATE TABLE bounds (
  world INTEGER NOT NULL REFERENCES worlds,
  maze INTEGER NOT NULL REFERENCES mazes,
  bound REAL,
  PRIMARY KEY (world, maze)) WITHOUT ROWID;
CREATE TABLE builds (
  id INTEGER PRIMARY KEY,
  version TEXT NOT NULL,
  compiler TEXT NOT NULL,
  processor TEXT NOT NULL,
  UNIQUE (version, compiler, processor));
CREATE TABLE contests (
  id INTEGER PRIMARY KEY,
  world INTEGER NOT NULL REFERENCES worlds,
  mouse INTEGER NOT NULL REFERENCES mice,
  maze INTEGER NOT NULL REFERENCES mazes,
  seed INTEGER NOT NULL,
  run INTEGER NOT NULL,
  race_seed TEXT NOT NULL,
  outcome TEXT NOT NULL,
  outcome_order INTEGER NOT NULL,
  never_started TEXT NOT NULL,
  score REAL,
  counted REAL,
  ratio REAL,
  fields TEXT NOT NULL,
  figures TEXT NOT NULL,
  build INTEGER NOT NULL REFERENCES builds,
  time INTEGER NOT NULL,
  UNIQUE (world, mouse, maze, seed));
CREATE TABLE timings (
  contest INTEGER PRIMARY KEY REFERENCES contests ON DELETE CASCADE,
  figures TEXT NOT NULL);

CREATE VIEW results AS
SELECT contests.id, worlds.name AS world, worlds.conditions, mice.name AS mouse, mazes.name AS maze, seed, run, race_seed,
       outcome, score, counted, ratio, fields, version, compiler, processor, time
  FROM contests
  JOIN worlds ON worlds.id = contests.world
  JOIN mice ON mice.id = contests.mouse
  JOIN mazes ON mazes.id = contests.maze
  JOIN builds ON builds.id = contests.build;

CREATE VIEW standings AS
SELECT worlds.name AS world, worlds.conditions, contests.world AS world_id, mice.name AS mouse, contests.mouse AS mouse_id,
       count(DISTINCT contests.maze) AS mazes, count(*) AS contests, count(score) AS solved, avg(counted) AS mean,
       avg(score) AS mean_solved, avg(ratio) AS mean_ratio
  FROM contests
  JOIN bounds ON bounds.world = contests.world AND bounds.maze = contests.maze AND bound IS NOT NULL
  JOIN worlds ON worlds.id = contests.world
  JOIN mice ON mice.id = contests.mouse
 GROUP BY contests.world, contests.mouse
 ORDER BY contests.world, mean;

CREATE VIEW pairs AS
WITH means AS (
  SELECT contests.world, contests.mouse, contests.maze, avg(counted) AS mean
    FROM contests
    JOIN bounds ON bounds.world = contests.world AND bounds.maze = contests.maze AND bound IS NOT NULL
   WHERE counted IS NOT NULL
   GROUP BY contests.world, contests.mouse, contests.maze)
SELECT worlds.name AS world, worlds.conditions, one.world AS world_id, mice.name AS mouse, one.mouse AS mouse_id,
       others.name AS against, other.mouse AS against_id, count(*) AS mazes, avg(one.mean - other.mean) AS difference,
       sum(one.mean < other.mean) AS better, sum(one.mean = other.mean) AS equal, sum(one.mean > other.mean) AS worse
  FROM means AS one
  JOIN means AS other ON other.world = one.world AND other.maze = one.maze AND other.mouse <> one.mouse
  JOIN worlds ON worlds.id = one.world
  JOIN mice ON mice.id = one.mouse
  JOIN mice AS others ON others.id = other.mouse
 GROUP BY one.world, one.mouse, other.mouse;
)";

constexpr std::array<const char*, 1> all_migrations = {first_version};

/// Why the path cannot be a store; empty where it can.
std::string refuse(const std::string& path, Database::Access access) {
  std::error_code error;
  if (path.empty()) return "the path of the store is empty";
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) return "is a folder; a store is one file";
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return "is no regular file, which a store has to be";
  const bool makes = access == Database::Access::create || access == Database::Access::scratch;
  if (!std::filesystem::exists(status) && !makes) return "there is no such store";
  return "";
}

/// The objects in a database's schema, such as "trigger x", with their SQL.
std::map<std::string, std::string> objects_of(Database& database) {
  std::map<std::string, std::string> objects;
  Statement rows = database.prepare(
      "SELECT type || ' ' || name AS name, tbl_name || char(10) || ifnull(sql, '') AS text FROM sqlite_master");
  while (rows.next()) objects[rows.text("name")] = rows.text("text");
  return objects;
}

/// The schema objects of a store of that version.
std::map<std::string, std::string> expected_objects(std::span<const char* const> steps, std::size_t version) {
  Database model(":memory:", Database::Access::create);
  for (std::size_t i = 0; i < version; ++i) model.run(steps[i]);
  return objects_of(model);
}

/// The tables that SQLite adds when a user runs ANALYZE.
bool is_statistics(const std::string& name, const std::string& text) {
  return (name == "table sqlite_stat1" && text == "sqlite_stat1\nCREATE TABLE sqlite_stat1(tbl,idx,stat)") ||
         (name == "table sqlite_stat4" &&
          text == "sqlite_stat4\nCREATE TABLE sqlite_stat4(tbl,idx,neq,nlt,ndlt,sample)");
}

/// The first schema object that does not belong to that version; empty where there is none. Foreign views and triggers
/// would run when the store is read or written.
std::string foreign_object(Database& database, std::span<const char* const> steps, std::size_t version) {
  const auto found = objects_of(database), expected = expected_objects(steps, version);
  for (const auto& [name, text] : found) {
    const auto same = expected.find(name);
    if (is_statistics(name, text)) continue;
    if (same == expected.end()) return fmt::format("has the {}, which labmouse did not make", name);
    if (same->second != text) return fmt::format("has a {} that labmouse did not make so", name);
  }
  for (const auto& [name, text] : expected)
    if (!found.contains(name)) return fmt::format("lacks the {}", name);
  return "";
}

/// Why the file is no store of a known version; empty where it is one, or where the file is empty.
std::string refuse(Database& database, std::span<const char* const> steps) {
  // One transaction, for a consistent view: another program may be creating the store now.
  database.run("BEGIN");
  const std::int64_t kind = database.number("PRAGMA application_id");
  const std::int64_t version = database.number("PRAGMA user_version");
  const std::int64_t tables = database.number("SELECT count(*) FROM sqlite_master");
  const auto newest = static_cast<std::int64_t>(steps.size());
  const std::string foreign = kind == application && version >= 0 && version <= newest
                                  ? foreign_object(database, steps, static_cast<std::size_t>(version))
                                  : "";
  database.run("COMMIT");
  if (kind != application && (kind != 0 || version != 0 || tables > 0))
    return "is a database, but no store of labmouse";
  if (version > newest)
    return fmt::format("was written by a later labmouse: its version is {}, and this program knows up to {}", version,
                       newest);
  return foreign.empty() ? "" : foreign + "; the file is not used: mend it with sqlite3, if you trust it";
}

/// Runs the missing migrations in one transaction.
void migrate(Database& database, std::span<const char* const> steps) {
  database.run("BEGIN IMMEDIATE");
  // Another program may have migrated it meanwhile.
  const auto version = static_cast<std::size_t>(database.number("PRAGMA user_version"));
  for (std::size_t i = version; i < steps.size(); ++i) database.run(steps[i]);
  if (version < steps.size())
    database.run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application, steps.size()));
  database.run("COMMIT");
  database.roll_back();
}

}  // namespace

std::string error_line(const std::string& path, const std::string& error) {
  return error.empty() ? "" : shown(fmt::format("{}: error: {}", path, error));
}

std::span<const char* const> migrations() { return all_migrations; }

Database open_store(const std::string& path, Database::Access access, std::span<const char* const> steps) {
  if (const std::string reason = refuse(path, access); !reason.empty()) {
    Database none(":memory:", Database::Access::create);
    none.fail(reason);
    return none;
  }
  Database database(path, access);
  if (database.good())
    if (const std::string reason = refuse(database, steps); !reason.empty()) database.fail(reason);
  const auto version = database.number("PRAGMA user_version");
  if (access != Database::Access::read) {
    // With WAL and FULL a committed contest survives a power failure.
    database.run_patiently(access == Database::Access::scratch
                               ? "PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF"
                               : "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
    migrate(database, steps);
  } else if (database.good() && version < static_cast<std::int64_t>(steps.size())) {
    database.fail(version == 0 ? "is an empty file, and no store yet"
                               : fmt::format("is of version {}; a race with --store {} brings it to {}", version, path,
                                             steps.size()));
  }
  return database;
}

Database open_checked_store(const std::string& path, Database::Access access) {
  Database database = open_store(path, access);
  Statement check = database.prepare("PRAGMA quick_check(1)");
  while (check.next())
    if (const std::string found = check.text(0); found != "ok") database.fail("is damaged: " + found);
  return database;
}

Database open_whole_store(const std::string& path) {
  Database database = open_store(path, Database::Access::read);
  Statement check = database.prepare("PRAGMA integrity_check(1)");
  while (check.next())
    if (const std::string found = check.text(0); found != "ok") database.fail("is damaged: " + found);
  if (database.number("SELECT count(*) FROM pragma_foreign_key_check") > 0)
    database.fail("is damaged: rows belong to others that are not there");
  return database;
}

}  // namespace labmouse
