#include "labmouse/lab/logs/log_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {
namespace {

constexpr double most_count = 1e12;
constexpr std::string_view duty_hint = "a duty is a share of what the battery can give: write left=NAME/255, say";

constexpr std::array<LogRoleWords, log_roles> words = {{
    {"time", "ms", "when the row was written", -1e12, 1e12},
    {"left", "", "duty of the left motor, -1 to 1, from this row to the next", -1.0, 1.0, duty_hint},
    {"right", "", "the same of the right one", -1.0, 1.0, duty_hint},
    {"left_count", "counts", "of the left encoder", -most_count, most_count},
    {"right_count", "counts", "of the right one", -most_count, most_count},
    {"left_speed", "mm/s", "of the left wheel, where there are no counts", -20'000.0, 20'000.0},
    {"right_speed", "mm/s", "of the right one", -20'000.0, 20'000.0},
    {"gyro", "rad/s", "yaw speed, to the left", -100.0, 100.0, "if it is in degrees/s, write gyro=NAME*0.0174533"},
    {"volts", "V", "of the battery", 0.1, 100.0, "if it is in mV, write volts=NAME/1000"},
    {"ir_right", "counts", "reading of the infrared sensor to the right", -1e6, 1e6},
    {"ir_right_ahead", "counts", "of the right one that looks ahead", -1e6, 1e6},
    {"ir_left", "counts", "of the one to the left", -1e6, 1e6},
    {"ir_left_ahead", "counts", "of the left one that looks ahead", -1e6, 1e6},
    {"wall_right", "mm", "from the middle of the axle to the wall to the right; empty where it is not known", 0.0,
     5000.0, "if it is in m, write wall_right=NAME*1000", true},
    {"wall_left", "mm", "the same to the left", 0.0, 5000.0, "if it is in m, write wall_left=NAME*1000", true},
    {"wall_ahead", "mm", "the same ahead", 0.0, 5000.0, "if it is in m, write wall_ahead=NAME*1000", true},
    {"way", "mm", "how far it has come, back counting less; empty where it is not known", -1e7, 1e7, "", true},
    {"speed", "mm/s", "how fast it was to drive", -20'000.0, 20'000.0},
    {"turning", "rad/s", "how fast it was to turn, to the left", -100.0, 100.0,
     "if it is in degrees/s, write turning=NAME*0.0174533"},
}};

/// The number at the end of a text, behind one of two signs; cut off there.
std::optional<double> cut_number(std::string_view& text, char sign) {
  const auto at = text.rfind(sign);
  if (at == std::string_view::npos || at + 1 == text.size()) return std::nullopt;
  const std::optional<double> number = number_in(text.substr(at + 1));
  if (number) text = text.substr(0, at);
  return number;
}

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

bool is_counter(std::size_t role) {
  return role == static_cast<std::size_t>(LogRole::left_count) ||
         role == static_cast<std::size_t>(LogRole::right_count);
}

/// One of the parts between commas; returns what is wrong with it.
std::string read_column(std::string_view part, LogColumns& columns) {
  std::string_view text = part;
  LogColumn column;
  if (const auto wraps = cut_number(text, '%')) {
    column.wraps = *wraps;
    if (!(column.wraps >= 2.0 && column.wraps <= most_count))
      return fmt::format("'{}': a counter wraps at a number from 2 on, such as 65536", shown(part));
  }
  if (const auto factor = cut_number(text, '*')) {
    column.factor = *factor;
  } else if (const auto divisor = cut_number(text, '/')) {
    column.factor = 1.0 / *divisor;
  }
  const double size = std::abs(column.factor);
  if (!(size >= 1e-12 && size <= 1e12)) return fmt::format("'{}': the factor cannot be that", shown(part));
  const auto equals = text.find('=');
  const std::string_view name = without_blanks(text.substr(0, equals));
  column.name = without_blanks(equals == std::string_view::npos ? text : text.substr(equals + 1));
  const auto* const found =
      std::find_if(words.begin(), words.end(), [&](const LogRoleWords& role) { return role.name == name; });
  if (found == words.end()) {
    std::vector<std::string_view> names;
    for (const LogRoleWords& role : words) names.push_back(role.name);
    const auto near = nearest_name(name, names);
    return fmt::format(
        "no column can be '{}'; {}", shown(name),
        near.empty() ? fmt::format("they are {}", fmt::join(names, ", ")) : fmt::format("did you mean '{}'?", near));
  }
  const auto index = static_cast<std::size_t>(found - words.begin());
  if (column.name.empty()) return fmt::format("'{}' has no column; write {}=NAME", name, name);
  if (column.wraps > 0.0 && !is_counter(index)) return fmt::format("'{}' is no counter, so it does not wrap", name);
  if (columns.of_role[index]) return fmt::format("'{}' stands twice", name);
  columns.of_role[index] = std::move(column);
  return "";
}

/// What goes together.
std::string check(const LogColumns& columns) {
  using Pair = std::pair<LogRole, LogRole>;
  for (const auto& [one, other] :
       {Pair{LogRole::left, LogRole::right}, Pair{LogRole::left_count, LogRole::right_count},
        Pair{LogRole::left_speed, LogRole::right_speed}, Pair{LogRole::speed, LogRole::turning}})
    if (columns[one].has_value() != columns[other].has_value())
      return fmt::format("'{}' and '{}' go together; name both or neither", words_of(one).name, words_of(other).name);
  if (columns[LogRole::left_count] && columns[LogRole::left_speed])
    return "'left_count' and 'left_speed' say the same; name one of them";
  if (columns[LogRole::time].has_value() == (columns.period > 0.0))
    return columns.period > 0.0 ? "the time is a column and has a period; say one of them"
                                : "no column has the time; name one, as in time=NAME, or give --period MS";
  return "";
}

}  // namespace

const LogRoleWords& words_of(LogRole role) { return words[static_cast<std::size_t>(role)]; }
std::span<const LogRoleWords> all_log_roles() { return words; }

LogColumnsResult read_log_columns(std::string_view text, double period) {
  LogColumnsResult result;
  result.columns.period = period;
  for (std::string_view rest = text; result.error.empty() && !rest.empty();) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    if (!without_blanks(part).empty()) result.error = read_column(without_blanks(part), result.columns);
  }
  if (result.error.empty()) result.error = check(result.columns);
  return result;
}

}  // namespace labmouse
