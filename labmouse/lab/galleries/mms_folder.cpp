#include "labmouse/lab/galleries/mms_folder.hpp"

#include <fmt/format.h>

#include "labmouse/lab/system/files.hpp"

namespace labmouse {

MmsRaceFolder::MmsRaceFolder(std::string folder, const MmsRace& race)
    : paths_(std::move(folder), names_of(race.mice), names_of(race.mazes)) {}

std::string MmsRaceFolder::save(const MmsResult& result, const std::string& record) const {
  const std::string path = paths_.mms_record(result.mouse, result.maze);
  const auto error = write_file(path, record);
  return error.empty() ? "" : fmt::format("{}: error: {}", path, error);
}

}  // namespace labmouse
