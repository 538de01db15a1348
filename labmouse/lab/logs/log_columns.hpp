// Which column of a log is what, as its owner says it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace labmouse {

/// What a column of a log can be.
enum class LogRole : unsigned char {
  time,
  left,
  right,
  left_count,
  right_count,
  left_speed,
  right_speed,
  gyro,
  volts,
  ir_right,
  ir_right_ahead,
  ir_left,
  ir_left_ahead,
  wall_right,
  wall_left,
  wall_ahead,
  way,
  speed,
  turning
};
inline constexpr std::size_t log_roles = 19;

/// One of them as docs/logs.md has it, and what a value of it may be.
struct LogRoleWords {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  double low = 0.0, high = 0.0;
  std::string_view hint{};  ///< what to write where a value is beyond that
  bool gaps = false;        ///< whether a field may be empty
};
const LogRoleWords& words_of(LogRole role);
std::span<const LogRoleWords> all_log_roles();

/// Where the values of a role stand.
struct LogColumn {
  std::string name;     ///< by the first line of the log, or its number with a #: "#3" is the third
  double factor = 1.0;  ///< of what stands there to the unit of the role
  double wraps = 0.0;   ///< a counter that begins again after so many; 0: it does not

  friend bool operator==(const LogColumn&, const LogColumn&) = default;
};

struct LogColumns {
  std::array<std::optional<LogColumn>, log_roles> of_role;
  double period = 0.0;  ///< ms from one row to the next, where no column has the time

  const std::optional<LogColumn>& operator[](LogRole role) const { return of_role[static_cast<std::size_t>(role)]; }
  std::optional<LogColumn>& operator[](LogRole role) { return of_role[static_cast<std::size_t>(role)]; }
};

/// The columns, or what is wrong with the words: exactly one of the two counts.
struct LogColumnsResult {
  LogColumns columns;
  std::string error;
};

/// Reads "time=ms,left=pwm_l/255,gyro*0.001": roles with their columns, a role alone being its own column's name, each
/// with a factor or divisor, and for counters behind that % and where they wrap.
LogColumnsResult read_log_columns(std::string_view text, double period);

}  // namespace labmouse
