#include "labmouse/lab/pictures/path_data.hpp"

#include <fmt/format.h>

namespace labmouse::drawing {

std::string data_through(const Frame& frame, const std::vector<DrivePathPoint>& path, std::size_t first,
                         std::size_t last) {
  std::string data;
  for (std::size_t i = first; i <= last; ++i)
    data += fmt::format("{}{:.1f} {:.1f}", i == first ? 'M' : 'L', frame.origin.x + path[i].x * Frame::cell,
                        frame.origin.y + (frame.size.height - path[i].y) * Frame::cell);
  return data;
}

}  // namespace labmouse::drawing
