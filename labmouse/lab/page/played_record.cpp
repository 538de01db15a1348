#include "labmouse/lab/page/played_record.hpp"

#include <fmt/format.h>

namespace labmouse {

PageFailure failure_of(const std::string& name, OpenedRecord& opened) {
  if (opened.replay) return {};
  if (opened.lacks_maze)
    return {fmt::format("{} is a record without its maze; open the maze first, then the record again", name), {}};
  if (!opened.problems.empty()) return {fmt::format("{} is not a readable record", name), std::move(opened.problems)};
  return {fmt::format("{} does not match its maze", name), {{0, 0, std::move(opened.disagreement)}}};
}

}  // namespace labmouse
