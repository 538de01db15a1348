#include "labmouse/lab/galleries/drive_folder.hpp"

#include <fmt/format.h>

#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/system/files.hpp"

namespace labmouse {
namespace {

std::string save_file(const std::string& path, const std::string& content) {
  const auto error = write_file(path, content);
  return error.empty() ? "" : fmt::format("{}: error: {}", path, error);
}

}  // namespace

DriveRaceFolder::DriveRaceFolder(std::string folder, const DriveRace& race)
    : paths_(std::move(folder), names_of(race.mice), names_of(race.mazes)) {}

std::string DriveRaceFolder::save(const DriveRace& race, const DriveResult& result, const DriveRecord& record) const {
  const DriveRecordFile file = drive_record_file_of(race, result, record);
  auto error = save_file(paths_.record(result.mouse, result.maze, result.run), write_drive_record(file));
  if (error.empty() && result.run == 0)
    error = save_file(paths_.picture(result.mouse, result.maze), draw_contest(file));
  return error;
}

}  // namespace labmouse
