// Any bytes as a store, or as changes to a good one: what reads stores, merges them and takes contests out of them says
// what is wrong, or goes on with what is there.
//
// A file of SQLite is taken as it is. Other texts are changes, a line each: TABLE COLUMN ROW VALUE, or bytes OFFSET
// VALUE.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/store/store.hpp"
#include "labmouse/lab/store/store_changes.hpp"
#include "labmouse/lab/store/stored_races.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

namespace fs = std::filesystem;

/// A folder of this process, in memory where there is such a place.
class Folder {
 public:
  Folder() { fs::create_directories(path_); }
  ~Folder() { fs::remove_all(path_); }
  std::string file(const char* name) const { return (path_ / name).string(); }
  /// The files beside a database go, too.
  void remove(const char* name) const {
    for (const char* more : {"", "-wal", "-shm", "-journal"}) fs::remove(file(name) + more);
  }

 private:
  fs::path path_ = (fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) /
                   ("labmouse-fuzz-store-" + std::to_string(getpid()));
};

void write(const std::string& path, std::string_view content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

Race race_with(const std::string& path) {
  const auto store = std::make_shared<Store>(path, Database::Access::scratch);
  RaceOrder order;
  order.world = first_world();
  order.runs = 2;
  order.jobs = 1;
  order.store = store;
  MazeDraft draft({3, 3}, MazeDraft::Inside::open);
  Race race = hold_race(read_specs("flood,random").contestants, {{"open", Maze(std::move(draft))}}, order);
  store->finish();
  return race;
}

/// A store of a small race, as a file.
std::string good_store(const Folder& folder) {
  race_with(folder.file("good.db"));
  std::ifstream file(folder.file("good.db"), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string_view word_of(std::string_view& line) {
  const std::string_view word = line.substr(0, line.find(' '));
  line.remove_prefix(std::min(line.size(), word.size() + 1));
  return word;
}

/// Only changes of rows: other statements could make anything of the file.
bool is_name(std::string_view word) {
  return !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string_view::npos;
}

std::size_t number_of(std::string_view word) {
  std::size_t number = 0;
  for (const char digit : word.substr(0, 6)) number = number * 10 + static_cast<unsigned char>(digit) % 16;
  return number;
}

/// Calls use(first word, rest) for each line, the first ones of very many.
template <class Use>
void for_each_line(std::string_view lines, Use use) {
  for (int left = 20; !lines.empty() && left > 0; --left) {
    std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    const std::string_view first = word_of(line);
    use(first, line);
  }
}

std::string with_changed_bytes(std::string content, std::string_view lines) {
  for_each_line(lines, [&](std::string_view first, std::string_view rest) {
    if (first != "bytes") return;
    const std::size_t at = number_of(word_of(rest)) % content.size();
    const std::size_t count = std::min(rest.size(), content.size() - at);
    content.replace(at, count, rest.substr(0, count));
  });
  return content;
}

void change_rows(const std::string& path, std::string_view lines) {
  for_each_line(lines, [&](std::string_view table, std::string_view rest) {
    const std::string_view column = word_of(rest), row = word_of(rest);
    if (!is_name(table) || table == "bytes" || !is_name(column)) return;
    Database database(path, Database::Access::write);
    database.run("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF; PRAGMA foreign_keys = OFF");
    Statement update = database.prepare("UPDATE OR IGNORE " + std::string(table) + " SET " + std::string(column) +
                                        " = ? WHERE rowid = " + std::to_string(number_of(row)));
    if (database.good()) update.bind(1, rest).run();
  });
}

void read_all(const std::string& path) {
  const StoreFilter all;
  const StoredMice mice = stored_mice(path, all);
  require(mice.error.empty() || mice.mice.empty());
  const StoredRaces races = stored_races(path, all);
  require(races.error.empty() || races.races.empty());
  for (const Race& race : races.races) require(!table_of(race, false).empty());
  if (!races.races.empty()) require(!json_of(races.races, {}).empty());
  for (const auto format : {ExportFormat::json_lines, ExportFormat::csv})
    export_store(path, all, format, 0, [](const std::string&) { return true; });
}

}  // namespace

LABMOUSE_FUZZER(store) {
  static const Folder folder;
  static const std::string good = good_store(folder);
  const std::string_view input(reinterpret_cast<const char*>(bytes), size);
  const std::string path = folder.file("fuzzed.db"), target = folder.file("target.db");
  const bool is_whole = input.starts_with("SQLite format 3");
  write(path, is_whole ? std::string(input) : with_changed_bytes(good, input));
  if (!is_whole) change_rows(path, input);
  read_all(path);
  write(target, good);
  const Merge merged = merge_stores({path}, target);
  require(merged.good() || merged.added == 0);
  race_with(path);
  StoreFilter flood;
  flood.mice = {"flood"};
  forget(path, flood);
  folder.remove("fuzzed.db");
  folder.remove("target.db");
  return 0;
}

}  // namespace labmouse::fuzz
