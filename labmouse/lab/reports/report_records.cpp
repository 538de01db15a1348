#include "labmouse/lab/reports/report_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/races/race_paths.hpp"
#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::size_t longest_file = std::size_t{1} << 28U;  // bytes
constexpr std::size_t block_size = 256;                      // records that are in memory at a time

/// A record whose file exists in the folder.
struct RecordPlace {
  std::string path;
  const ReportMouse* mouse = nullptr;
  const std::string* maze = nullptr;
  const std::set<std::uint64_t>* seeds = nullptr;
  const ReportWorld* world = nullptr;
};

/// The result of reading one: a packed record, or a note why there is none.
struct Found {
  std::string packed;
  std::optional<Maze> maze;
  std::string note;
  /// False in worlds that set start and goals themselves, where the maze differs from its file.
  bool own_places = true;
};

Found failed(const RecordPlace& place, std::string_view reason) {
  return {"", std::nullopt, shown(fmt::format("{}: error: {}", place.path, reason))};
}

Found failed(const RecordPlace& place, const Problem& problem) {
  return {"", std::nullopt, describe(place.path, problem)};
}

std::string text_of_packed(const Replay& replay) {
  return replay.packed().dump(-1, ' ', false, Json::error_handler_t::replace);
}

Found read_place(const RecordPlace& place) {
  const FileContent file = read_found_file(place.path, longest_file);
  if (!file.error.empty()) return failed(place, file.error);
  const WorldEntry& world = *place.world->entry;
  const OpenedRecord opened = world.records->open(file.content, nullptr);
  if (!opened.problems.empty()) return failed(place, opened.problems.front());
  if (!opened.disagreement.empty()) return failed(place, "the record does not match its maze: " + opened.disagreement);
  const RecordSubject of = opened.replay->subject();
  if (of.mouse != place.mouse->name || of.maze.name != *place.maze || (of.seed && !place.seeds->contains(*of.seed)))
    return failed(place, fmt::format("does not belong to this race: it is of {} in {}{}", of.mouse, of.maze.name,
                                     of.seed ? fmt::format(" with seed {}", *of.seed) : ""));
  return {text_of_packed(*opened.replay), of.maze.maze, "", world.make({}).world->traits().fixed_places.empty()};
}

/// The path of a record, with or without the number of the run in its name; empty where there is no such file.
std::string path_of(const RacePaths& numbered, const RacePaths& single, std::size_t mouse, std::size_t maze) {
  for (const RacePaths* paths : {&numbered, &single}) {
    std::string path = paths->record(mouse, maze, 0);
    std::error_code unknown;
    if (std::filesystem::exists(path, unknown)) return path;
  }
  return "";
}

/// Adds the record files of a world, in the order of the results. `missing` counts those that do not exist.
void add_places(const ReportWorld& world, const std::string& folder, std::vector<RecordPlace>& places, int& missing) {
  std::vector<std::string> mice = names_of(world.mice), mazes = names_of(world.mazes);
  std::sort(mice.begin(), mice.end());
  std::sort(mazes.begin(), mazes.end());
  const RacePaths numbered(folder, mice, mazes), single(folder, mice, mazes, false);
  const auto position = [](const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::lower_bound(names.begin(), names.end(), name) - names.begin());
  };
  for (const ReportMouse& mouse : world.mice)
    for (const auto& [maze, seeds] : mouse.seeds) {
      const std::size_t row = position(mice, mouse.name), column = position(mazes, maze);
      if (column == mazes.size() || mazes[column] != maze) continue;
      std::string path = path_of(numbered, single, row, column);
      if (path.empty())
        ++missing;
      else
        places.push_back({std::move(path), &mouse, &maze, &seeds, &world});
    }
}

/// Collects packed records until there is no more room.
class Shelf {
 public:
  explicit Shelf(std::size_t room, std::map<std::string, Maze> mazes = {}) : room_(room) {
    records_.mazes = std::move(mazes);
  }

  bool full() const { return left_out_ > 0; }
  void leave_out(std::size_t count) { left_out_ += count; }

  void add(const RecordPlace& place, Found found) {
    if (found.note.empty() && found.maze && found.own_places &&
        records_.mazes.try_emplace(*place.maze, *found.maze).first->second != *found.maze)
      found = failed(place, "its maze differs from the one that other records of this race have under that name");
    if (!found.note.empty()) return records_.notes.push_back(std::move(found.note));
    if (!add(found.packed)) return;
    // A maze whose start and goals the world has set is used only where there is none of that name yet.
    if (!found.own_places && found.maze) records_.mazes.try_emplace(*place.maze, *found.maze);
  }

  /// Adds a packed record; returns false where there is no room.
  bool add(const std::string& packed) {
    if (full() || packed.size() > room_) return leave_out(1), false;
    room_ -= packed.size();
    list_ += (list_.empty() ? "" : ",") + packed;
    return true;
  }

  ReportRecords finish() {
    records_.json = fmt::format(R"({{"records":[{}],"left_out":{}}})", list_, left_out_);
    return std::move(records_);
  }

  std::size_t left_out() const { return left_out_; }
  void note(std::string line) { records_.notes.push_back(std::move(line)); }

 private:
  ReportRecords records_;
  std::string list_;
  std::size_t room_;
  std::size_t left_out_ = 0;
};

}  // namespace

ReportRecords read_report_records(const ReportResults& results, const std::string& folder, std::size_t most_bytes) {
  std::vector<RecordPlace> places;
  int missing = 0;
  for (const ReportWorld& world : results.worlds) add_places(world, folder, places, missing);
  Shelf shelf(most_bytes);
  for (std::size_t begin = 0; begin < places.size(); begin += block_size) {
    const std::size_t count = std::min(block_size, places.size() - begin);
    if (shelf.full()) {
      shelf.leave_out(count);
      continue;
    }
    std::vector<Found> found(count);
    for_each_parallel(count, 0, [&](std::size_t i) { found[i] = read_place(places[begin + i]); });
    for (std::size_t i = 0; i < count; ++i) shelf.add(places[begin + i], std::move(found[i]));
  }
  if (shelf.full())
    shelf.note(fmt::format("left out: {} of {} records, because together they exceed {} bytes", shelf.left_out(),
                           places.size(), most_bytes));
  if (missing > 0 && !places.empty())
    shelf.note(fmt::format("left out: {} missing from {}", counted(missing, "record", "records"), shown(folder)));
  return shelf.finish();
}

ReportRecords pack_records(const WorldEntry& world, std::span<const std::string> texts,
                           std::map<std::string, Maze> mazes, std::size_t most_bytes) {
  Shelf shelf(most_bytes, std::move(mazes));
  for (const std::string& text : texts) {
    const OpenedRecord opened = world.records->open(text, nullptr);
    if (opened.replay)
      shelf.add(text_of_packed(*opened.replay));
    else
      shelf.note("left out: a record that cannot be played again");
  }
  if (shelf.full())
    shelf.note(fmt::format("left out: {} of {} records, because together they exceed {} bytes", shelf.left_out(),
                           texts.size(), most_bytes));
  return shelf.finish();
}

}  // namespace labmouse
