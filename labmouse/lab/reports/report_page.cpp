#include "labmouse/lab/reports/report_page.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/races/race_paths.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/packing.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view place = "<!-- labmouse:report -->";
constexpr std::size_t longest_results = std::size_t{1} << 28U;  // bytes

/// A block with compressed text. Base64 has no characters with a meaning in HTML, so nothing needs escaping.
std::string block(std::string_view id, std::string_view json) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, base64(gzip(json)));
}

/// The maze of that name, if size and optimum are still those of the results.
std::optional<Maze> find_again(const ReportMaze& wanted) {
  auto maze = maze_named(wanted.name);
  if (!maze || maze->size() != wanted.size) return std::nullopt;
  if (wanted.optimum && bound_of(*maze, Rules()).optimum != wanted.optimum) return std::nullopt;
  return maze;
}

/// A link for each maze, by its name. Adds a line to `notes` where mazes are not found.
Json links_of(const ReportResults& results, const ReportRecords& records, std::vector<std::string>& notes) {
  Json links = Json::object();
  std::set<std::string> lost;
  for (const ReportWorld& world : results.worlds)
    for (const ReportMaze& wanted : world.mazes) {
      if (links.contains(wanted.name)) continue;
      const auto recorded = records.mazes.find(wanted.name);
      const auto maze = recorded != records.mazes.end() ? recorded->second : find_again(wanted);
      if (maze)
        links[wanted.name] = link_of({wanted.name, *maze});
      else
        lost.insert(wanted.name);
    }
  if (!lost.empty())
    notes.push_back(shown(fmt::format("left out: {} that cannot be found again as raced, such as {}",
                                      counted(lost.size(), "maze", "mazes"), *lost.begin())));
  return links;
}

ReportPage failed(std::string error) { return {"", std::move(error), {}}; }

}  // namespace

std::string wrong_page(std::string_view page) {
  const auto first = page.find(place);
  if (first == std::string_view::npos) return fmt::format("is not the labmouse page: it has no {}", place);
  if (page.find(place, first + 1) != std::string_view::npos)
    return fmt::format("is not the labmouse page: it has more than one {}", place);
  return "";
}

std::string with_report(std::string_view page, std::string_view report, std::string_view records) {
  const auto at = page.find(place);
  std::string text(page.substr(0, at));
  text += block("labmouse-report", report) + block("labmouse-records", records);
  return text.append(page.substr(at + place.size()));
}

ReportPage make_report(const std::string& path, std::string_view page) {
  std::error_code unknown;
  const bool is_folder = fs::is_directory(path, unknown);
  const std::string file = is_folder ? (fs::path(path) / results_file_name).string() : path;
  if (is_folder && !fs::exists(file, unknown))
    return failed(
        shown(fmt::format("{}: error: has no {}; `labmouse race --out DIR` creates one", path, results_file_name)));
  const FileContent content = read_file(file, longest_results);
  if (!content.error.empty()) return failed(shown(fmt::format("{}: error: {}", file, content.error)));
  const ReadResultsResult read = read_report_results(content.content);
  if (!read.results) return failed(describe(file, *read.problem));
  const fs::path parent = fs::path(file).parent_path();
  return make_report(*read.results, read_report_records(*read.results, parent.empty() ? "." : parent.string()), page);
}

ReportPage make_report(const ReportResults& results, ReportRecords records, std::string_view page) {
  const std::string report =
      fmt::format(R"({{"labmouse":"report","format":2,"version":{},"results":{},"mazes":{}}})", Json(version()).dump(),
                  results.json, links_of(results, records, records.notes).dump());
  return {with_report(page, report, records.json), "", std::move(records.notes)};
}

}  // namespace labmouse
