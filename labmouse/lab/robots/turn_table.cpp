#include "labmouse/lab/robots/turn_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::array<std::string_view, 7> columns = {"turn", "speed", "ms", "x", "y", "before", "after"};

struct Word {
  std::string_view text;
  int column;  ///< where it stands, from 1
};

std::vector<Word> words_of(std::string_view line) {
  constexpr std::string_view between = " \t,\r";
  std::vector<Word> words;
  for (std::size_t at = line.find_first_not_of(between); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(between, at), line.size());
    words.push_back({line.substr(at, end - at), static_cast<int>(at) + 1});
    at = line.find_first_not_of(between, end);
  }
  return words;
}

class Reader {
 public:
  void read(std::string_view text) {
    for (int line = 1; !text.empty(); ++line) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const auto words = words_of(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      if (words.empty() || words.front().text.starts_with('#')) continue;
      line_ = line;
      names_.empty() ? read_names(words) : read_turn(words);
    }
    if (names_.empty() && table_.problems.empty()) add(0, "is empty; its first line must name its columns");
    if (!names_.empty() && table_.turns.empty() && table_.problems.empty()) add(0, "has no turns");
    if (!table_.problems.empty()) table_.turns.clear();
  }
  TurnTable& table() { return table_; }

 private:
  void add(int column, std::string reason) {
    if (table_.problems.size() < most_problems)
      table_.problems.push_back({column == 0 ? 0 : line_, column, std::move(reason)});
  }

  void read_names(const std::vector<Word>& words) {
    for (const Word& word : words) {
      if (std::find(columns.begin(), columns.end(), word.text) == columns.end())
        add(word.column,
            fmt::format("unknown column '{}'; columns are {}", shown(word.text), fmt::join(columns, ", ")));
      if (std::find(names_.begin(), names_.end(), word.text) != names_.end())
        add(word.column, fmt::format("column '{}' stands twice", shown(word.text)));
      names_.push_back(word.text);
    }
    if (names_.front() != "turn") add(words.front().column, "the first column must be 'turn'");
  }

  void read_turn(const std::vector<Word>& words) {
    if (words.size() != names_.size())
      return add(words.front().column,
                 fmt::format("has {} columns; the first line names {}", words.size(), names_.size()));
    KnownTurn turn;
    if (!read_name(words.front(), turn)) return;
    const std::size_t problems = table_.problems.size();
    for (std::size_t i = 1; i < words.size(); ++i) {
      double* const value = value_of(turn, names_[i]);
      const std::optional<double> number = number_of(words[i]);
      if (value != nullptr && number) *value = *number;
    }
    if (table_.problems.size() > problems) return;
    if (turn.milliseconds == 0.0 && (turn.speed == 0.0 || turn.aside == 0.0))
      return add(words.front().column, "needs its time ('ms'), or its speed with the size of its curve ('speed', 'y')");
    table_.turns.push_back(turn);
  }

  bool read_name(const Word& word, KnownTurn& turn) {
    turn.wide = word.text == "K90";
    constexpr std::array known = {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90, Turn::s90};
    const auto* found = std::find_if(known.begin(), known.end(),
                                     [&](Turn one) { return name_of(one) == (turn.wide ? "V90" : word.text); });
    if (found == known.end())
      return add(word.column,
                 fmt::format("unknown turn '{}'; turns are 45, 90, 135, 180, V90, S90 and K90", shown(word.text))),
             false;
    turn.turn = *found;
    return true;
  }

  static double* value_of(KnownTurn& turn, std::string_view name) {
    if (name == "speed") return &turn.speed;
    if (name == "ms") return &turn.milliseconds;
    if (name == "y") return &turn.aside;
    return name == "before" ? &turn.before : nullptr;
  }

  std::optional<double> number_of(const Word& word) {
    if (word.text == "-") return std::nullopt;
    const std::optional<double> number = number_in(word.text);
    // Of less no robot has a figure, and the fit would run out of numbers.
    if (number && (*number == 0.0 || (*number >= 0.001 && *number <= 1e6))) return number;
    add(word.column, fmt::format("'{}' must be 0, a number from 0.001 to 1000000, or - for none", shown(word.text)));
    return std::nullopt;
  }

  TurnTable table_;
  std::vector<std::string_view> names_;
  int line_ = 0;
};

}  // namespace

TurnTable read_turn_table(std::string_view text) {
  Reader reader;
  reader.read(text);
  return std::move(reader.table());
}

}  // namespace labmouse
