#include "labmouse/lab/result_folders/race_folder.hpp"

#include <fmt/format.h>

#include "labmouse/lab/system/files.hpp"

namespace labmouse {
namespace {

std::string save_file(const std::string& path, const std::string& content) {
  if (content.empty()) return "";
  const auto error = write_file(path, content);
  return error.empty() ? "" : fmt::format("{}: error: {}", path, error);
}

}  // namespace

RaceFolder::RaceFolder(std::string folder, const Race& race)
    : paths_(std::move(folder), names_of(race.mice), names_of(race.mazes), race.world().traits().numbers_runs) {}

std::string RaceFolder::save(const ContestResult& contest, const ContestOutput& held) const {
  const auto error = save_file(paths_.record(contest.mouse, contest.maze, contest.run), held.record);
  return error.empty() ? save_file(paths_.picture(contest.mouse, contest.maze), held.picture) : error;
}

}  // namespace labmouse
