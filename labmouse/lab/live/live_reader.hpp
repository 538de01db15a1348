// Reads the stream of a real robot: bytes that come in pieces, with noise and lost parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/live/live_line.hpp"

namespace labmouse {

/// Splits a stream into lines and reads them. How the bytes are split into pieces does not matter. After the first
/// right checksum, a line without one is noise, because its end was lost.
class LiveReader {
 public:
  /// More bytes than this are noise.
  static constexpr std::size_t longest_line = 1024;

  /// @param size of the maze: drawings of other sizes are noise.
  explicit LiveReader(Size size = {16, 16}) : size_(size) {}

  /// Adds bytes.
  /// @return what the lines say that end in them. The rest of the last line is kept.
  std::vector<LiveLine> feed(std::string_view bytes);

  /// How many lines have ended, and how many of these are noise. Blank lines are none.
  std::int64_t lines() const { return lines_; }
  std::int64_t noise() const { return noise_; }

 private:
  void end_line(std::vector<LiveLine>& read);
  /// Whether the line is a part of a drawing; its last line is what a drawing says.
  bool takes_drawn_line(std::vector<LiveLine>& read);

  Size size_;
  std::string drawing_;  ///< the lines of a drawing that has begun
  int drawn_lines_ = 0;
  std::string line_;  ///< the begin of a line that has not ended
  bool is_too_long_ = false;
  bool has_checksums_ = false;
  std::int64_t lines_ = 0;
  std::int64_t noise_ = 0;
};

}  // namespace labmouse
