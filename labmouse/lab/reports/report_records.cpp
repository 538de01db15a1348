#include "labmouse/lab/reports/report_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/races/race_paths.hpp"
#include "labmouse/lab/records/packed_record.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_file = std::size_t{1} << 28U;  // bytes
constexpr std::size_t block_size = 256;                      // records that are in memory at a time

/// A record that may lie in the folder.
struct Place {
  std::string path;
  const ReportMouse* mouse = nullptr;
  const std::string* maze = nullptr;
  const std::set<std::uint64_t>* seeds = nullptr;
  bool mms = false;
};

/// What was found there: a packed record, or a note why there is none, or neither.
struct Found {
  std::string packed;
  std::optional<Maze> maze;
  std::string note;
};

Found failed(const Place& place, std::string_view reason) {
  return {"", std::nullopt, shown(fmt::format("{}: error: {}", place.path, reason))};
}

Found failed(const Place& place, const Problem& problem) { return {"", std::nullopt, describe(place.path, problem)}; }

std::string packed_text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Found pack(const Place& place, const std::string& text) {
  ReadRecordResult read = read_record(text);
  if (!read.file) return failed(place, read.problems.front());
  RecordFile& file = *read.file;
  if (!file.maze) return failed(place, "the record has no maze");
  if (file.mouse != place.mouse->name || file.maze_name != *place.maze || !place.seeds->contains(file.seed))
    return failed(
        place, fmt::format("is not of this race, but of {} in {} with seed {}", file.mouse, file.maze_name, file.seed));
  const ReplayResult played = replay(file, *file.maze);
  if (!played.disagreement.empty()) return failed(place, "does not agree with its maze: " + played.disagreement);
  return {packed_text(pack_record(file)), file.maze, ""};
}

/// The first line of the text that is not JSON; 0 where all are.
int first_bad_line(std::string_view text) {
  for (int line = 1; !text.empty(); ++line) {
    const auto length = std::min(text.find('\n'), text.size());
    if (!Json::accept(text.substr(0, length))) return line;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return 0;
}

/// A record of mms goes in as it is.
Found pack_mms(const Place& place, const std::string& text) {
  if (const int line = first_bad_line(text); line > 0) return failed(place, {line, 1, "the line is not JSON"});
  Json header = Json::parse(text.substr(0, text.find('\n')), nullptr, false);
  if (!header.is_object() || header.value("labmouse", Json()) != "mms record")
    return failed(place, {1, 1, "is not the header of a record of mms"});
  // But for that word its header is that of a record, so that one reader serves both.
  header["labmouse"] = "record";
  ReadRecordResult read = read_record(packed_text(header));
  if (!read.file) return failed(place, read.problems.front());
  if (read.file->mouse != place.mouse->name || read.file->maze_name != *place.maze)
    return failed(place, fmt::format("is not of this race, but of {} in {}", read.file->mouse, read.file->maze_name));
  return {packed_text({{"mouse", read.file->mouse}, {"maze", read.file->maze_name}, {"mms", text}}), read.file->maze,
          ""};
}

Found read_place(const Place& place) {
  const FileContent file = read_found_file(place.path, longest_file);
  if (!file.error.empty()) return failed(place, file.error);
  return place.mms ? pack_mms(place, file.content) : pack(place, file.content);
}

/// Where the records of a world lie that the results speak of, in the order of the results; `missing` counts those that
/// are not there.
void add_places(const ReportWorld& world, bool mms, const std::string& folder, std::vector<Place>& places,
                int& missing) {
  std::vector<std::string> mice = names_of(world.mice), mazes = names_of(world.mazes);
  std::sort(mice.begin(), mice.end());
  std::sort(mazes.begin(), mazes.end());
  const RacePaths paths(folder, mice, mazes);
  const auto position = [](const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::lower_bound(names.begin(), names.end(), name) - names.begin());
  };
  for (const ReportMouse& mouse : world.mice)
    for (const auto& [maze, seeds] : mouse.seeds) {
      const std::size_t row = position(mice, mouse.name), column = position(mazes, maze);
      if (column == mazes.size() || mazes[column] != maze) continue;
      std::string path = mms ? paths.mms_record(row, column) : paths.record(row, column, 0);
      std::error_code unknown;
      if (std::filesystem::exists(path, unknown))
        places.push_back({std::move(path), &mouse, &maze, &seeds, mms});
      else
        ++missing;
    }
}

/// Takes what was found, as far as there is room.
class Shelf {
 public:
  explicit Shelf(std::size_t room) : room_(room) {}

  bool full() const { return left_out_ > 0; }
  void leave_out(std::size_t count) { left_out_ += count; }

  void add(const Place& place, Found found) {
    if (found.note.empty() && found.maze && !place.mms &&
        records_.mazes.try_emplace(*place.maze, *found.maze).first->second != *found.maze)
      found = failed(place, "its maze is not the one that other records of this race have under that name");
    if (!found.note.empty()) return records_.notes.push_back(std::move(found.note));
    if (full() || found.packed.size() > room_) return leave_out(1);
    room_ -= found.packed.size();
    list_ += (list_.empty() ? "" : ",") + found.packed;
    // Mazes of mms start and end elsewhere; they are a makeshift where no other record has the maze.
    if (place.mms && found.maze) records_.mazes.try_emplace(*place.maze, *found.maze);
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
  std::vector<Place> places;
  int missing = 0;
  add_places(results.steps, false, folder, places, missing);
  add_places(results.mms, true, folder, places, missing);
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
    shelf.note(fmt::format("left out: {} of {} records, since together they have more than {} bytes", shelf.left_out(),
                           places.size(), most_bytes));
  if (missing > 0 && !places.empty())
    shelf.note(fmt::format("left out: {} that should lie in {}", counted(missing, "record", "records"), shown(folder)));
  return shelf.finish();
}

}  // namespace labmouse
