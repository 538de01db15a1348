#include "labmouse/lab/logs/log_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

struct Field {
  std::string_view text;
  int column = 0;  ///< where it stands, from 1
};

char separator_of(std::string_view line) {
  for (const char separator : {',', ';', '\t'})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

std::string_view bare(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  if (first == std::string_view::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

/// The fields of a line; between blanks there are no empty ones.
void split(std::string_view line, char separator, std::vector<Field>& fields) {
  fields.clear();
  for (std::size_t at = 0; at <= line.size();) {
    if (separator == ' ') at = std::min(line.find_first_not_of(" \r", at), line.size());
    if (separator == ' ' && at == line.size()) return;
    const std::size_t end = std::min(line.find(separator, at), line.size());
    fields.push_back({bare(line.substr(at, end - at)), static_cast<int>(at) + 1});
    at = end + 1;
  }
}

/// Programs that write logs may put a plus in front.
std::string_view without_plus(std::string_view text) { return text.starts_with('+') ? text.substr(1) : text; }

bool is_nothing(std::string_view text) { return text.empty() || text == "-" || text == "nan" || text == "NaN"; }

/// A name from a file in a message: not longer than a line.
std::string shortened(std::string_view name) {
  constexpr std::size_t most = 24;
  return name.size() <= most ? shown(name) : shown(name.substr(0, most)) + "...";
}

std::string list_of(const std::vector<Field>& names) {
  constexpr std::size_t most = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += (i == 0 ? "" : ", ") + shortened(names[i].text);
  return names.size() > most ? list + fmt::format(" and {} more", names.size() - most) : list;
}

class LogReader {
 public:
  explicit LogReader(const LogColumns& columns) : columns_(columns) {}

  LogResult read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    bool begun = false;
    while (!text.empty() && good()) {
      ++line_;
      const std::size_t end = text.find('\n');
      whole_ = end != std::string_view::npos;
      const std::string_view line = text.substr(0, end);
      text.remove_prefix(whole_ ? end + 1 : text.size());
      if (bare(line).empty() || line.starts_with('#')) continue;
      if (!begun) separator_ = separator_of(line);
      split(line, separator_, fields_);
      if (begun) {
        read_row();
      } else {
        begin();
        begun = true;
      }
    }
    if (good() && result_.log.times.size() < 2) {
      line_ = 0;
      fail(0, !begun                      ? "is empty"
              : result_.log.times.empty() ? "has no rows below its first line"
                                          : "has one row, which says nothing");
    }
    if (!good()) result_.log = {};
    return std::move(result_);
  }

 private:
  struct Place {
    std::size_t role = 0;
    std::size_t field = 0;
    LogColumn column;
    double before = 0.0, around = 0.0;  ///< of a counter: what stood in the row before, and how often it wrapped
  };

  bool good() const { return result_.problems.empty(); }
  void fail(int column, std::string reason) {
    if (good()) result_.problems.push_back({line_, column, std::move(reason)});
  }

  /// The first line, which names the columns or is a row.
  void begin() {
    width_ = fields_.size();
    named_ = std::any_of(fields_.begin(), fields_.end(),
                         [](const Field& field) { return !is_nothing(field.text) && !number_in(field.text); });
    for (std::size_t role = 0; role < log_roles; ++role)
      if (const auto& column = columns_.of_role[role]) place(role, *column);
    if (!named_) read_row();
  }

  void place(std::size_t role, const LogColumn& column) {
    const std::string_view what = all_log_roles()[role].name;
    if (column.name.starts_with('#')) {
      const std::optional<double> number = number_in(std::string_view(column.name).substr(1));
      if (!number || *number < 1.0 || *number != std::floor(*number) || *number > static_cast<double>(width_))
        return fail(
            1, fmt::format("has no column {} for '{}'; its first line has {}", shortened(column.name), what, width_));
      places_.push_back({role, static_cast<std::size_t>(*number) - 1, column});
      return;
    }
    if (!named_)
      return fail(1, fmt::format("does not name its columns, so none is '{}'; say which by their numbers, as in {}=#1",
                                 shortened(column.name), what));
    const auto is_it = [&](const Field& field) { return field.text == column.name; };
    const auto found = std::find_if(fields_.begin(), fields_.end(), is_it);
    if (found == fields_.end())
      return fail(1, fmt::format("has no column '{}' for '{}'; its columns are {}", shortened(column.name), what,
                                 list_of(fields_)));
    if (const auto again = std::find_if(found + 1, fields_.end(), is_it); again != fields_.end())
      return fail(again->column, fmt::format("names '{}' twice; say which one by its number, as in {}=#{}",
                                             shortened(column.name), what, again - fields_.begin() + 1));
    places_.push_back({role, static_cast<std::size_t>(found - fields_.begin()), column});
  }

  void read_row() {
    if (!good()) return;
    if (fields_.size() != width_) {
      const std::string counts = fmt::format("has {} fields, and the first line {}", fields_.size(), width_);
      return fail(1, whole_ ? counts : counts + ": the log is cut off here; take this line out");
    }
    for (Place& place : places_) read_value(place);
    if (good()) check_time();
  }

  void read_value(Place& place) {
    const Field& field = fields_[place.field];
    const LogRoleWords& words = all_log_roles()[place.role];
    double value = std::numeric_limits<double>::quiet_NaN();
    if (!is_nothing(field.text)) {
      const std::optional<double> number = number_in(without_plus(field.text));
      if (!number)
        return fail(field.column,
                    fmt::format("'{}' for '{}' {}{}", shortened(field.text), words.name,
                                why_no_number(without_plus(field.text)),
                                field.text.find(',') == std::string_view::npos ? "" : "; write decimals as in 0.5"));
      value = place.column.factor * unwrapped(place, *number);
      // Rounding by a factor is no fault of the log.
      const double slack = 1e-6 * words.high;
      if (!(value >= words.low - slack && value <= words.high + slack))
        return fail(field.column, fmt::format("'{}' is {:g}; it must be {:g} to {:g}{}{}{}{}", words.name, value,
                                              words.low, words.high, words.unit.empty() ? "" : " ", words.unit,
                                              words.hint.empty() ? "" : "; ", words.hint));
    } else if (!words.gaps) {
      return fail(field.column, fmt::format("has no value for '{}'", words.name));
    }
    result_.log.values[place.role].push_back(value);
  }

  double unwrapped(Place& place, double number) const {
    const double wraps = place.column.wraps;
    if (wraps == 0.0) return number;
    if (!result_.log.values[place.role].empty()) place.around -= std::round((number - place.before) / wraps) * wraps;
    place.before = number;
    return number + place.around;
  }

  void check_time() {
    std::vector<double>& times = result_.log.times;
    const auto& stamps = result_.log.values[static_cast<std::size_t>(LogRole::time)];
    const double time =
        stamps.empty() ? static_cast<double>(times.size()) * columns_.period : stamps.back() - stamps.front();
    if (!times.empty()) {
      const double step = time - times.back();
      if (!(step > 0.0)) return fail(1, fmt::format("the time goes from {:g} to {:g} ms", times.back(), time));
      if (step > most_log_gap)
        return fail(1, fmt::format("the time goes on by {:g} ms; a log has no gaps of more than {:g} ms: cut it here, "
                                   "or say its unit, as in time=NAME*1000",
                                   step, most_log_gap));
      if (time > most_log_time)
        return fail(1, fmt::format("is longer than {:g} s; cut it here", most_log_time / 1000.0));
    }
    times.push_back(time);
  }

  const LogColumns& columns_;
  LogResult result_;
  std::vector<Place> places_;
  std::vector<Field> fields_;
  char separator_ = ',';
  std::size_t width_ = 0;
  bool named_ = false, whole_ = true;
  int line_ = 0;
};

}  // namespace

LogResult read_log(std::string_view text, const LogColumns& columns) { return LogReader(columns).read(text); }

}  // namespace labmouse
