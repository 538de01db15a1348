#include "labmouse/lab/records/drive_notation.hpp"

#include <fmt/format.h>

namespace labmouse {

std::string notation_of(const DriveSegment& segment, const DriveTables& tables) {
  if (segment.kind == DriveSegment::Kind::straight)
    return fmt::format("{}{}", segment.diagonal() ? 'D' : 'S', segment.units);
  return fmt::format("{}{}", segment.left ? 'L' : 'R', name_of(tables.turns[segment.turn].turn));
}

std::string notation_of(const DriveRoute& route, const DriveTables& tables) {
  std::string text;
  for (const DriveSegment& segment : route.segments)
    if (segment.kind == DriveSegment::Kind::turn || segment.units > 0)
      text += (text.empty() ? "" : " ") + notation_of(segment, tables);
  return text;
}

}  // namespace labmouse
