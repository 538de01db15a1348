// Detects an endless loop of an mms program: the commands that it repeats at its end.
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
  std::int64_t first_line = 0;        ///< line of the program where the repetition begins
  bool began_earlier = false;         ///< it may have begun before that line, which is the oldest one known
  std::vector<std::string> commands;  ///< one round, in order
  std::vector<Cell> cells;            ///< cells entered in one round, in order
};

/// The last commands of a program that had a reply, with the pose after each. Commands that only draw are left out,
/// because texts may differ from round to round.
class MmsTrail {
 public:
  /// Number of commands kept: enough for three rounds of most loops in a maze of 32×32.
  static constexpr std::size_t most = std::size_t{1} << 16U;

  /// Adds a line with a reply, its number among all lines, and the pose after it.
  void add(std::string_view line, std::int64_t number, const HalfPose& pose);

  std::size_t size() const { return steps_.size(); }

  /// The longest repetition at the end of a program that wrote `lines` lines, of at least three rounds and 32 commands.
  /// nullopt if there is none, or if the program has since written only lines without a reply.
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

  std::vector<Step> steps_;  ///< ring buffer of `most` steps
  std::size_t next_ = 0;
};

/// "from line 57 on it repeats the same 4 commands in the cells (2,2) (2,1)", or that no loop was found.
std::string loop_text(const MmsTrail& trail, std::int64_t lines);

}  // namespace labmouse
