#include "labmouse/lab/reports/race_page.hpp"

#include <map>

#include "labmouse/lab/reports/report_page.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {

std::string race_page(const Race& race, const std::vector<std::string>& records, std::string_view page) {
  if (race.results.empty()) return std::string(page);
  std::map<std::string, Maze> mazes;
  for (const NamedMaze& maze : race.mazes) mazes.try_emplace(maze.name, maze.maze);
  std::vector<std::string> kept;
  for (const std::string& record : records)
    if (!record.empty()) kept.push_back(record);
  const ReadResultsResult results = read_report_results(json_of(race, {}));
  if (!results.results) return std::string(page);
  const WorldEntry& world = *find_world(race.world().traits().name);
  return make_report(*results.results, pack_records(world, kept, std::move(mazes)), page).page;
}

}  // namespace labmouse
