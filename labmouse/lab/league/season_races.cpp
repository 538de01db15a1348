#include "labmouse/lab/league/season_races.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/mazes/secret_mazes.hpp"
#include "labmouse/lab/races/race_order.hpp"
#include "labmouse/lab/reports/file_kind.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/store/contest_key.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_record = std::size_t{64} << 20U;  // bytes

std::vector<Contestant> mice_of(const League& league) {
  std::vector<Contestant> mice = league.builtin;
  for (Contestant& mouse : mice) mouse.runs = 1;
  for (const LeagueEntry& entry : league.entries) mice.push_back(entry.mouse);
  return mice;
}

/// Names the records of a race by all that determines them.
class RecordPaths {
 public:
  RecordPaths(const League& league, std::string folder, std::vector<Contestant>& mice, std::vector<NamedMaze>& mazes,
              std::uint64_t seed)
      : folder_(std::move(folder)), world_(key_of(*league.world)), seed_(seed) {
    std::sort(mice.begin(), mice.end(), in_race_order);
    std::sort(mazes.begin(), mazes.end(), in_race_order);
    for (const Contestant& mouse : mice) mice_.push_back(mouse.name + "\n" + key_of(*league.world, mouse));
    for (const NamedMaze& maze : mazes) mazes_.push_back(maze.name + "\n" + key_of(maze.maze));
  }

  std::string of(const ContestResult& contest) const {
    const std::string all =
        fmt::format("{}\n{}\n{}\n{} {}", world_, mice_[contest.mouse], mazes_[contest.maze], seed_, contest.run);
    return fmt::format("{}/{}.json", folder_, sha256_text(all).substr(0, 32));
  }

 private:
  std::string folder_, world_;
  std::uint64_t seed_;
  std::vector<std::string> mice_, mazes_;
};

/// The paths of the folder of a league, as programs print them in their messages.
std::vector<std::string> paths_of(const League& league) {
  std::error_code unknown;
  const fs::path absolute = fs::absolute(league.folder, unknown).lexically_normal();
  std::vector<std::string> paths;
  for (const fs::path& path : {absolute, fs::weakly_canonical(absolute, unknown)})
    if (path.has_relative_path()) paths.push_back((path / "").string());
  return paths;
}

/// The text with paths relative to the folder.
std::string without_paths(std::string text, const std::vector<std::string>& paths) {
  for (const std::string& path : paths)
    for (auto at = text.find(path); at != std::string::npos; at = text.find(path, at)) text.erase(at, path.size());
  return text;
}

/// Removes what differs between two computers: paths, and times by the clock.
void remove_traces(RecordedRace& recorded, const std::vector<std::string>& paths) {
  Race& race = recorded.race;
  for (Contestant& mouse : race.mice) {
    mouse.spec = mouse.name;
    mouse.mice_file.clear();
    mouse.interpreter.reset();
  }
  const StoredFigures& stored = race.world().traits().fields->figures;
  for (ContestResult& contest : race.results) {
    contest.never_started = without_paths(std::move(contest.never_started), paths);
    contest = without_clock(std::move(contest), *race.world().traits().fields);
    if (contest.figures == nullptr) continue;
    std::vector<Value> figures = stored.values_of(*contest.figures);
    for (Value& figure : figures)
      if (auto* text = std::get_if<std::string>(&figure)) *text = without_paths(std::move(*text), paths);
    contest.figures = stored.figures_of(figures);
  }
  for (std::string& record : recorded.records) record = without_paths(std::move(record), paths);
}

/// The record at that path; empty where there is none.
/// @param error gets the first problem, as a line for the user.
std::string record_at(const std::string& path, std::string& error) {
  std::error_code unknown;
  if (fs::symlink_status(path, unknown).type() == fs::file_type::not_found) return "";
  FileContent file = read_found_file(path, longest_record);
  if (file.error.empty() && kind_of_file(file.content) != FileKind::record)
    file.error = "is not the record of a contest";
  if (!file.error.empty() && error.empty())
    error = shown(fmt::format("{}: error: {}; remove it, and run the season again", path, file.error));
  return std::move(file.content);
}

/// Runs one of the two races of a season.
RecordedRace run_race(const League& league, const SeasonOrder& order, std::vector<NamedMaze> mazes, std::uint64_t seed,
                      std::size_t all, SeasonRaces& races) {
  std::vector<Contestant> mice = mice_of(league);
  const std::string folder =
      order.records.empty() ? fmt::format("{}/{}", league.folder, records_folder_name) : order.records;
  const RecordPaths paths(league, folder, mice, mazes, seed);
  RaceOrder race_order;
  race_order.world = league.world;
  race_order.runs = 1;
  race_order.seed = seed;
  // Programs get other seeds than the contests, so that they cannot foresee what is random in them.
  race_order.first_told = 1;
  race_order.jobs = order.jobs;
  race_order.shard = order.shard;
  race_order.store = order.store;
  race_order.files = league.hidden();
  std::atomic<bool> failed = false;
  RaceHooks hooks;
  hooks.stop = order.stop;
  hooks.keep = [&](const ContestResult& contest) {
    std::error_code unknown;
    return Keep{!std::filesystem::exists(paths.of(contest), unknown), false};
  };
  hooks.finished = [&](const Race&, const ContestResult& contest, const ContestOutput& output) {
    if (order.advanced) order.advanced(all, !output.record.empty());
    if (output.record.empty() || !contest.judged || failed) return;
    const std::string path = paths.of(contest), error = write_file(path, output.record);
    if (error.empty()) return;
    failed = true;
    races.error = shown(fmt::format("{}: error: {}", path, error));
  };
  RecordedRace recorded;
  recorded.race = hold_race(std::move(mice), std::move(mazes), race_order, hooks);
  races.stopped = races.stopped || recorded.race.stopped;
  if (races.stopped) return recorded;
  for (const ContestResult& contest : recorded.race.results) {
    races.not_judged += contest.judged ? 0 : 1;
    recorded.records.push_back(record_at(paths.of(contest), races.error));
  }
  remove_traces(recorded, paths_of(league));
  return recorded;
}

}  // namespace

SeasonRaces run_season(const League& league, const SeasonOrder& order) {
  SeasonRaces races;
  races.error = refuse_examination(*league.world, league.season.examination, order.secret);
  if (!races.error.empty()) {
    races.error = "error: " + races.error;
    return races;
  }
  std::vector<NamedMaze> examination = examination_mazes(league.season.examination, order.secret);
  const std::size_t mice = league.builtin.size() + league.entries.size();
  const auto contests_in = [&](std::size_t mazes) {
    return (mice * mazes + order.shard.of - order.shard.number) / order.shard.of;
  };
  const std::size_t all = contests_in(league.practice.size()) + contests_in(examination.size());
  races.practice = run_race(league, order, league.practice, 1, all, races);
  if (races.stopped) return races;
  races.examination =
      run_race(league, order, std::move(examination), number_from(order.secret, "contests"), all, races);
  return races;
}

std::vector<MouseShares> examination_shares(const Race& examination) {
  std::vector<MouseShares> all;
  for (const Contestant& mouse : examination.mice)
    all.push_back({mouse.name, std::vector<double>(examination.mazes.size(), 0.0)});
  for (const ContestResult& contest : examination.results)
    all[contest.mouse].shares[contest.maze] = share_of_best(examination, contest).value_or(0.0);
  return all;
}

}  // namespace labmouse
