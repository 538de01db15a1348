#include "labmouse/lab/store/stored_races.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/store/contest_key.hpp"
#include "labmouse/lab/store/contest_rows.hpp"
#include "labmouse/lab/store/differences.hpp"
#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

std::string sql_text(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "''" : std::string(1, letter);
  return quoted + "'";
}

/// The mouse of a row; nothing where its parameters cannot be read.
std::optional<Contestant> mouse_of(const Statement& row) {
  Contestant mouse;
  mouse.name = row.text("name");
  if (const std::string spec = row.text("spec"); spec != mouse.name) mouse.spec = spec;
  const std::string& spec = spec_of(mouse);
  const BuiltinMouse* entry = find_mouse(spec.substr(0, spec.find(':')));
  const ReadJson parameters = read_json(row.text("parameters"));
  if (!parameters.is_object()) return std::nullopt;
  if (entry != nullptr) {
    mouse.settings = Settings(entry->parameters);
    for (const Parameter& parameter : entry->parameters) {
      const auto found = parameters.find(parameter.name);
      if (found != parameters.end() && found->is_string())
        mouse.settings.set(parameter.name, found->get<std::string>());
    }
  }
  read_about(row.text("about"), mouse);
  mouse.identity = [key = row.text("text")] { return key; };
  return mouse;
}

void tell_apart(std::vector<StoredMouse>& mice) {
  std::map<std::string, std::vector<std::string>> conditions;  // by world
  for (const StoredMouse& mouse : mice) {
    std::vector<std::string>& of_world = conditions[mouse.world];
    if (std::find(of_world.begin(), of_world.end(), mouse.conditions) == of_world.end())
      of_world.push_back(mouse.conditions);
  }
  for (const auto& [world, of_world] : conditions) {
    const std::vector<std::string> told = differences_of(of_world);
    for (StoredMouse& mouse : mice)
      for (std::size_t i = 0; i < of_world.size(); ++i)
        if (mouse.world == world && mouse.conditions == of_world[i]) mouse.apart = told[i];
  }
}

/// Reads the rows of one world into a race.
class Reader {
 public:
  Reader(Database& database, std::string condition) : database_(database), condition_(std::move(condition)) {}

  /// Reads the race; nothing where the maze of a row cannot be read.
  std::optional<Race> read(std::int64_t world_id, std::shared_ptr<const World> world) {
    Race race;
    race.order.world = std::move(world);
    Statement rows =
        database_.prepare(fmt::format("SELECT contests.mouse AS mouse, contests.maze AS maze, seed, {} FROM contests "
                                      "LEFT JOIN timings ON timings.contest = contests.id "
                                      "WHERE contests.world = ?1 AND contests.id IN (SELECT id FROM results{})",
                                      result_columns, condition_));
    rows.bind(1, world_id);
    while (rows.next()) {
      const auto mouse = place_of(mice_, rows.whole("mouse")), maze = place_of(mazes_, rows.whole("maze"));
      ContestResult contest;
      contest.mouse = mouse;
      contest.maze = maze;
      contest.seed = static_cast<std::uint64_t>(rows.whole("seed"));
      if (!fill_in(rows, race.world(), contest)) {
        database_.fail("is damaged: it has results that cannot be read");
        return std::nullopt;
      }
      race.results.push_back(std::move(contest));
    }
    if (!add_mice(race) || !add_mazes(race)) return std::nullopt;
    sort(race);
    race.facts.resize(race.mazes.size());
    for_each_parallel(race.mazes.size(), 0,
                      [&](std::size_t i) { race.facts[i] = race.world().facts(race.mazes[i].maze); });
    return race;
  }

 private:
  using Places = std::map<std::int64_t, std::size_t>;

  static std::size_t place_of(Places& places, std::int64_t id) {
    return places.try_emplace(id, places.size()).first->second;
  }

  bool add_mice(Race& race) {
    race.mice.resize(mice_.size());
    Statement find = database_.prepare("SELECT text, name, spec, parameters, about FROM mice WHERE id = ?1");
    for (const auto& [id, place] : mice_) {
      find.bind(1, id);
      while (find.next()) {
        std::optional<Contestant> mouse = mouse_of(find);
        if (!mouse) {
          database_.fail("is damaged: it has a mouse whose parameters cannot be read");
          return false;
        }
        race.mice[place] = *std::move(mouse);
      }
    }
    return database_.good();
  }

  bool add_mazes(Race& race) {
    std::map<std::size_t, NamedMaze> found;
    std::map<std::string, int> names;
    Statement find = database_.prepare("SELECT text, name FROM mazes WHERE id = ?1");
    for (const auto& [id, place] : mazes_) {
      find.bind(1, id);
      while (find.next()) {
        ReadLinkResult link = read_link(find.text("text"));
        if (!link.maze) {
          database_.fail("is damaged: it has a maze that cannot be read");
          return false;
        }
        std::string name = find.text("name");
        // Another maze with the same name.
        if (const int count = ++names[name]; count > 1) name += fmt::format(" ({})", count);
        found.emplace(place, NamedMaze{std::move(name), link.maze->maze});
      }
    }
    for (auto& [place, maze] : found) race.mazes.push_back(std::move(maze));
    return database_.good() && race.mazes.size() == mazes_.size();
  }

  /// Sorts things by name and returns the new position of each.
  template <class Things>
  static std::vector<std::size_t> sort_by_name(Things& things) {
    std::vector<std::size_t> order(things.size()), places(things.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return things[a].name < things[b].name; });
    Things sorted;
    for (std::size_t i = 0; i < order.size(); ++i) {
      sorted.push_back(std::move(things[order[i]]));
      places[order[i]] = i;
    }
    things = std::move(sorted);
    return places;
  }

  static void sort(Race& race) {
    const auto mice = sort_by_name(race.mice), mazes = sort_by_name(race.mazes);
    for (ContestResult& contest : race.results) {
      contest.mouse = mice[contest.mouse];
      contest.maze = mazes[contest.maze];
    }
    std::sort(race.results.begin(), race.results.end(), [](const ContestResult& a, const ContestResult& b) {
      return std::tie(a.mouse, a.maze, a.run, a.seed) < std::tie(b.mouse, b.maze, b.run, b.seed);
    });
  }

  Database& database_;
  std::string condition_;
  Places mice_, mazes_;
};

std::string with(const std::string& condition, const std::string& more) {
  return condition + (condition.empty() ? " WHERE " : " AND ") + more;
}

/// Of mice with one name, takes those without a learned prior, and of these the last one to race.
std::string only_latest(const std::string& condition) {
  return fmt::format(
      "contests.mouse IN (SELECT mouse FROM (SELECT mouse, row_number() OVER (PARTITION BY contests.world, mice.name "
      "ORDER BY instr(mice.text, char(10) || 'learned ') > 0, max(time) DESC, max(contests.id) DESC) AS place FROM "
      "contests JOIN mice ON mice.id = mouse WHERE "
      "contests.id IN (SELECT id FROM results{}) GROUP BY contests.world, mouse) WHERE place = 1)",
      condition);
}

/// The only seed of the rows; an error where there are several.
std::string seed_of(Database& database, const std::string& condition) {
  std::vector<std::string> seeds;
  Statement find = database.prepare(
      fmt::format("SELECT DISTINCT race_seed FROM results{} ORDER BY length(race_seed), race_seed LIMIT 6", condition));
  while (find.next()) seeds.push_back(find.text("race_seed"));
  if (seeds.size() > 1) {
    if (seeds.size() == 6) seeds.back() = "...";
    database.fail(fmt::format("holds races with seeds {}; name one with --seed", fmt::join(seeds, ", ")));
  }
  if (seeds.empty()) database.fail("has no such contests");
  return seeds.empty() ? "" : seeds.front();
}

StoredRaces read_races(const std::string& path, StoreFilter filter, bool one_race) {
  StoredRaces found;
  Database database = open_whole_store(path);
  database.run("BEGIN");
  std::string condition = condition_of(filter);
  const std::string seed = one_race && database.good() ? seed_of(database, condition) : "";
  struct StoredWorld {
    std::int64_t id;
    std::string name, conditions, text;
  };
  std::vector<StoredWorld> worlds;
  Statement find = database.prepare("SELECT id, name, conditions, text FROM worlds ORDER BY id");
  while (find.next())
    worlds.push_back({find.whole("id"), find.text("name"), find.text("conditions"), find.text("text")});
  if (one_race) {
    const std::int64_t all = database.number(
        fmt::format("SELECT count(DISTINCT mouse) FROM contests WHERE id IN (SELECT id FROM results{})", condition));
    condition = with(condition, "id IN (SELECT contests.id FROM contests WHERE " + only_latest(condition) + ")");
    const std::int64_t latest = database.number(
        fmt::format("SELECT count(DISTINCT mouse) FROM contests WHERE id IN (SELECT id FROM results{})", condition));
    if (latest < all)
      found.remarks.push_back(fmt::format("{} with the name of a later one left out",
                                          all - latest == 1 ? "1 mouse" : fmt::format("{} mice", all - latest)));
  }
  for (const auto& [id, name, conditions, text] : worlds) {
    if (!database.good()) break;
    if (!filter.worlds.empty() && std::find(filter.worlds.begin(), filter.worlds.end(), name) == filter.worlds.end())
      continue;
    auto world = restore_world(name, conditions);
    if (!world || key_of(*world) != text) {
      found.remarks.push_back(
          fmt::format("world {} left out: it is not as this version of labmouse has it", shown(name)));
      continue;
    }
    auto race = Reader(database, condition).read(id, std::move(world));
    if (!race || race->results.empty()) continue;
    // Valid: fill_in() has parsed it in each row.
    race->order.seed = one_race ? *parse_whole<std::uint64_t>(seed) : 0;
    found.races.push_back(std::move(*race));
  }
  found.error = error_line(path, database.error());
  if (found.error.empty() && found.races.empty()) found.error = error_line(path, "has no such contests");
  return found;
}

/// Warns where some mouse has no contest in some maze: their means are then not comparable.
void remark_on_holes(StoredRaces& found) {
  for (const Race& race : found.races) {
    std::vector<std::size_t> met(race.mice.size() * race.mazes.size());
    for (const ContestResult& contest : race.results) met[contest.mouse * race.mazes.size() + contest.maze] = 1;
    const auto holes = std::count(met.begin(), met.end(), 0U);
    if (holes > 0)
      found.remarks.push_back(
          fmt::format("world {}: the store has no contest for {} of {} pairs of a mouse and a maze, so means are not "
                      "over the same mazes",
                      race.world().traits().name, holes, met.size()));
  }
}

constexpr std::array<const char*, 16> export_columns = {
    "world", "conditions", "mouse", "maze",   "seed",    "run",      "race_seed", "outcome",
    "score", "counted",    "ratio", "fields", "version", "compiler", "processor", "time"};

std::string joined_columns() { return fmt::format("{}", fmt::join(export_columns, ", ")); }

bool is_real(std::string_view column) { return column == "score" || column == "counted" || column == "ratio"; }

Json json_of_column(const Statement& rows, const char* column) {
  const std::string_view name = column;
  if (rows.is_null(column)) return nullptr;
  if (is_real(name)) return *rows.real(column);
  if (name == "seed" || name == "run" || name == "time") return rows.whole(column);
  if (name == "conditions" || name == "fields") {
    const std::string text = rows.text(column);
    Json json = read_ordered_json(text);
    return json.is_discarded() ? Json(text) : json;
  }
  return rows.text(column);
}

std::string json_line(const Statement& rows) {
  Json json;
  for (const char* column : export_columns) json[column] = json_of_column(rows, column);
  return one_line(json) + "\n";
}

std::string csv_line(const Statement& rows) {
  std::string line;
  for (const char* column : export_columns) {
    const auto real = is_real(column) ? rows.real(column) : std::nullopt;
    line +=
        (column == export_columns.front() ? "" : ",") + csv_field(real ? fmt::format("{}", *real) : rows.text(column));
  }
  return line + "\n";
}

}  // namespace

std::string condition_of(const StoreFilter& filter) {
  std::string condition;
  const auto among = [&](const char* column, const std::vector<std::string>& names) {
    if (names.empty()) return;
    std::vector<std::string> quoted;
    for (const std::string& name : names) quoted.push_back(sql_text(name));
    condition = with(condition, fmt::format("{} IN ({})", column, fmt::join(quoted, ", ")));
  };
  std::vector<std::string> worlds = filter.worlds;
  for (const std::string& name : filter.worlds)
    if (const WorldEntry* entry = find_world(name); entry != nullptr)
      for (const std::string_view other : {entry->name, entry->former_name}) worlds.emplace_back(other);
  among("world", worlds);
  among("mouse", filter.mice);
  among("maze", filter.mazes);
  among("version", filter.versions);
  if (filter.race_seed) condition = with(condition, fmt::format("race_seed = '{}'", *filter.race_seed));
  return condition;
}

StoredRaces stored_races(const std::string& path, const StoreFilter& filter) {
  StoredRaces found = read_races(path, filter, true);
  remark_on_holes(found);
  return found;
}

StoredRaces all_stored_contests(const std::string& path, const StoreFilter& filter) {
  return read_races(path, filter, false);
}

StoredMice stored_mice(const std::string& path, const StoreFilter& filter) {
  StoredMice found;
  Database database = open_whole_store(path);
  Statement rows = database.prepare(fmt::format(
      "SELECT worlds.name AS world, worlds.conditions AS conditions, mice.name AS mouse, count(DISTINCT contests.maze) "
      "AS mazes, "
      "count(*) AS contests, count(score) AS finished, avg(CASE WHEN bound IS NOT NULL THEN counted END) AS mean, "
      "min(time) AS first, max(time) AS last FROM contests "
      "JOIN worlds ON worlds.id = contests.world JOIN mice ON mice.id = contests.mouse "
      "LEFT JOIN bounds ON bounds.world = contests.world AND bounds.maze = contests.maze "
      "WHERE contests.id IN (SELECT id FROM results{}) GROUP BY contests.world, contests.mouse "
      "ORDER BY contests.world, mice.name, max(time)",
      condition_of(filter)));
  while (rows.next())
    found.mice.push_back({.world = rows.text("world"),
                          .conditions = rows.text("conditions"),
                          .mouse = rows.text("mouse"),
                          .apart = "",
                          .mazes = rows.whole("mazes"),
                          .contests = rows.whole("contests"),
                          .finished = rows.whole("finished"),
                          .mean = rows.real("mean"),
                          .first = rows.whole("first"),
                          .last = rows.whole("last")});
  tell_apart(found.mice);
  found.error = error_line(path, database.error());
  return found;
}

std::string export_store(const std::string& path, const StoreFilter& filter, ExportFormat format, std::int64_t most,
                         const std::function<bool(const std::string& lines)>& take) {
  constexpr std::size_t part = std::size_t{1} << 16U;
  Database database = open_whole_store(path);
  const std::string last =
      most > 0 ? fmt::format("(SELECT * FROM results{} ORDER BY id DESC LIMIT {})", condition_of(filter), most)
               : "results" + condition_of(filter);
  // The order in which threads store contests is random, so all of them are sorted by their names.
  const char* order = most > 0 ? "id" : "world, mouse, maze, seed, id";
  Statement rows = database.prepare(fmt::format("SELECT {} FROM {} ORDER BY {}", joined_columns(), last, order));
  std::string lines;
  if (format == ExportFormat::csv && database.good()) lines = fmt::format("{}\n", fmt::join(export_columns, ","));
  while (rows.next()) {
    lines += format == ExportFormat::csv ? csv_line(rows) : json_line(rows);
    if (lines.size() < part) continue;
    if (!take(lines)) return "";
    lines.clear();
  }
  if (!lines.empty() && database.good()) take(lines);
  return error_line(path, database.error());
}

}  // namespace labmouse
