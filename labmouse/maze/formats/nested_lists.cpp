#include "labmouse/maze/formats/nested_lists.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "labmouse/functions/parse_number.hpp"

namespace labmouse::formats {
namespace {

/// A drawing of 64x64 cells as blocks has 129x129 numbers.
constexpr std::size_t most_items = 20'000;
constexpr std::size_t most_depth = 6;

bool is_word(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_'; }

/// Signs and points belong to numbers, so that -1 and 1.5 are not read as 1.
bool is_in_number(char letter) { return letter == '.' || letter == '-' || letter == '+'; }

/// The number of a word such as 13, 0x0D, 0b1101, 13u or 13.0.
std::optional<unsigned> number_of_word(std::string_view word) {
  if (word == "true" || word == "True") return 1U;
  if (word == "false" || word == "False") return 0U;
  while (!word.empty() && (word.back() == 'u' || word.back() == 'U' || word.back() == 'l' || word.back() == 'L'))
    word.remove_suffix(1);
  if (word.starts_with("0x") || word.starts_with("0X")) return parse_whole<unsigned>(word.substr(2), 16);
  if (word.starts_with("0b") || word.starts_with("0B")) return parse_whole<unsigned>(word.substr(2), 2);
  // NumPy prints whole numbers of floating-point arrays as 1. and 1.0
  if (const std::size_t point = word.find('.');
      word.find_first_not_of('0', std::min(point, word.size() - 1) + 1) == std::string_view::npos)
    word = word.substr(0, point);
  return parse_whole<unsigned>(word);
}

std::size_t leaves_of(const ListItem& item) {
  if (item.kind != ListItem::Kind::list) return 1;
  std::size_t count = 0;
  for (const ListItem& each : item.items) count += leaves_of(each);
  return count;
}

class ListReader {
 public:
  ListReader(std::string_view content, ProblemList& problems) : rest_(content), problems_(problems) {}

  int equal() const { return equal_; }

  std::optional<ListItem> read() {
    while (!rest_.empty() && problems_.empty()) next();
    if (problems_.empty() && !open_.empty())
      problems_.add(open_.back().line, open_.back().column, "the list that begins here has no end");
    if (problems_.empty() && !longest_) problems_.add(0, 0, "there is no list of numbers or strings");
    return problems_.empty() ? std::move(longest_) : std::nullopt;
  }

 private:
  void next() {
    const char letter = rest_.front();
    if (letter == '"' || letter == '\'') return read_string(letter);
    if (letter == '{' || letter == '[' || letter == '(') return begin();
    if (letter == '}' || letter == ']' || letter == ')') return end();
    if (rest_.starts_with("//") || letter == '#') return skip(rest_.find('\n'));
    if (rest_.starts_with("/*")) {
      const std::size_t end = rest_.find("*/");
      return skip(end == std::string_view::npos ? end : end + 2);
    }
    if (is_word(letter) || (!open_.empty() && is_in_number(letter))) return read_word();
    if (letter == ':' && !open_.empty() && !open_.back().items.empty()) name_next();
    skip(1);
  }

  void skip(std::size_t length) {
    length = std::min(length, rest_.size());
    for (const char letter : rest_.substr(0, length)) {
      ++column_;
      if (letter == '\n') ++line_, column_ = 1;
    }
    rest_.remove_prefix(length);
  }

  void read_string(char quote) {
    const std::size_t end = rest_.find_first_of(std::string{quote, '\n'}, 1);
    if (end == std::string_view::npos || rest_[end] != quote) {
      // Prose before a list can have an apostrophe.
      if (!open_.empty()) problems_.add(line_, column_, "the string that begins here has no end in its line");
      return skip(1);
    }
    add({.kind = ListItem::Kind::string, .text = rest_.substr(1, end - 1), .line = line_, .column = column_});
    skip(end + 1);
  }

  void read_word() {
    std::size_t length = 1;
    while (length < rest_.size() && (is_word(rest_[length]) || is_in_number(rest_[length]))) ++length;
    const std::string_view word = rest_.substr(0, length);
    if (!open_.empty()) {
      if (const std::optional<unsigned> number = number_of_word(word))
        add({.kind = ListItem::Kind::number, .number = *number, .line = line_, .column = column_});
      else if (rest_.substr(length).starts_with(':'))  // a key without quotes
        add({.kind = ListItem::Kind::string, .text = word, .line = line_, .column = column_});
      else
        add({.kind = ListItem::Kind::word, .text = word, .line = line_, .column = column_});
    }
    skip(length);
  }

  void add(ListItem item) {
    if (open_.empty()) return;
    if (++count_ > most_items) return give_up("more numbers and strings than a maze has");
    item.key = std::exchange(key_, {});
    open_.back().items.push_back(std::move(item));
  }

  /// The string before a colon is the key of what follows.
  void name_next() {
    ListItem& last = open_.back().items.back();
    if (last.kind != ListItem::Kind::string || !key_.empty()) return;
    key_ = last.text;
    open_.back().items.pop_back();
  }

  void begin() {
    if (open_.size() == most_depth) return give_up("lists in lists in more than six levels");
    open_.push_back({.key = std::exchange(key_, {}), .line = line_, .column = column_});
    skip(1);
  }

  void end() {
    skip(1);
    if (open_.empty()) return;
    ListItem list = std::move(open_.back());
    open_.pop_back();
    if (!open_.empty()) {
      open_.back().items.push_back(std::move(list));
    } else if (!longest_ || leaves_of(list) > leaves_of(*longest_)) {
      longest_ = std::move(list);
      equal_ = 0;
    } else if (leaves_of(list) == leaves_of(*longest_)) {
      ++equal_;
    }
  }

  void give_up(std::string reason) { problems_.add(line_, column_, std::move(reason)); }

  std::string_view rest_;
  ProblemList& problems_;
  int line_ = 1, column_ = 1;
  std::vector<ListItem> open_;
  std::string_view key_;
  std::optional<ListItem> longest_;
  int equal_ = 0;  ///< further lists of the same length
  std::size_t count_ = 0;
};

}  // namespace

std::optional<ListItem> read_lists(std::string_view content, ProblemList& problems, int& equal) {
  ListReader reader(content, problems);
  std::optional<ListItem> longest = reader.read();
  equal = reader.equal();
  return longest;
}

}  // namespace labmouse::formats
