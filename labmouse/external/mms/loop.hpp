// The loop that a program for mms is in: the commands that it repeats at its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/external/mms/half_pose.hpp"

namespace labmouse {

/// The same commands, at the same places, over and over until the end.
struct MmsLoop {
  std::int64_t first_line = 0;        ///< of the program: where the repetition begins
  bool began_earlier = false;         ///< it may have begun before that line, which is the oldest one known
  std::vector<std::string> commands;  ///< one round, in order
  std::vector<Cell> cells;            ///< the same: each cell that the mouse came into
};

/// The last commands of a program that had a reply, with the place after each. Lines without a reply only draw, and
/// what a mouse writes into the maze may differ from round to round.
class MmsTrail {
 public:
  /// So many are kept: three rounds of most loops in a maze of 32×32.
  static constexpr std::size_t most = std::size_t{1} << 16U;

  /// A line with a reply, its number among all lines, and the place after it.
  void add(std::string_view line, std::int64_t number, const HalfPose& pose);

  std::size_t size() const { return steps_.size(); }

  /// The longest repetition at the end, of a program that wrote so many lines: at least three rounds and 32 commands.
  /// Nothing where there is none, or where the program left it for lines without a reply.
  std::optional<MmsLoop> loop(std::int64_t lines) const;

 private:
  struct Step {
    std::string line;
    HalfPose pose;
    std::int64_t number = 0;
  };
  static bool same(const Step& one, const Step& other) { return one.pose == other.pose && one.line == other.line; }
  /// Counted from the end; 0 is the last one.
  const Step& last(std::size_t back) const;

  std::vector<Step> steps_;  ///< once there are `most`, the next one overwrites the oldest
  std::size_t next_ = 0;
};

/// "from line 57 on it repeats the same 4 commands in the cells (2,2) (2,1)", or that no loop was found.
std::string loop_text(const MmsTrail& trail, std::int64_t lines);

}  // namespace labmouse
