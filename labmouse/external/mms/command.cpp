#include "labmouse/external/mms/command.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "labmouse/external/mms/canvas.hpp"
#include "labmouse/external/mms/statistics.hpp"
#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

/// Kind of arguments of a command.
enum class Form : std::uint8_t { nothing, cells, half_steps, statistic, wall, colour, cell, text };

struct Entry {
  std::string_view name;
  MmsVerb verb;
  Form form;
  int eighths = 0;
};

/// All commands.
constexpr std::array entries = {
    Entry{"ackReset", MmsVerb::ack_reset, Form::nothing},
    Entry{"clearAllColor", MmsVerb::clear_all_colour, Form::nothing},
    Entry{"clearAllText", MmsVerb::clear_all_text, Form::nothing},
    Entry{"clearColor", MmsVerb::clear_colour, Form::cell},
    Entry{"clearText", MmsVerb::clear_text, Form::cell},
    Entry{"clearWall", MmsVerb::clear_wall, Form::wall},
    Entry{"getStat", MmsVerb::get_stat, Form::statistic},
    Entry{"mazeHeight", MmsVerb::maze_height, Form::nothing},
    Entry{"mazeWidth", MmsVerb::maze_width, Form::nothing},
    Entry{"moveForward", MmsVerb::move, Form::cells},
    Entry{"moveForwardHalf", MmsVerb::move, Form::half_steps},
    Entry{"setColor", MmsVerb::set_colour, Form::colour},
    Entry{"setText", MmsVerb::set_text, Form::text},
    Entry{"setWall", MmsVerb::set_wall, Form::wall},
    Entry{"turnLeft", MmsVerb::turn, Form::nothing, -2},
    Entry{"turnLeft45", MmsVerb::turn, Form::nothing, -1},
    Entry{"turnLeft90", MmsVerb::turn, Form::nothing, -2},
    Entry{"turnRight", MmsVerb::turn, Form::nothing, 2},
    Entry{"turnRight45", MmsVerb::turn, Form::nothing, 1},
    Entry{"turnRight90", MmsVerb::turn, Form::nothing, 2},
    Entry{"wallBack", MmsVerb::wall, Form::half_steps, 4},
    Entry{"wallBackLeft", MmsVerb::wall, Form::half_steps, 5},
    Entry{"wallBackRight", MmsVerb::wall, Form::half_steps, 3},
    Entry{"wallFront", MmsVerb::wall, Form::half_steps, 0},
    Entry{"wallFrontLeft", MmsVerb::wall, Form::half_steps, 7},
    Entry{"wallFrontRight", MmsVerb::wall, Form::half_steps, 1},
    Entry{"wallLeft", MmsVerb::wall, Form::half_steps, 6},
    Entry{"wallRight", MmsVerb::wall, Form::half_steps, 2},
    Entry{"wasReset", MmsVerb::was_reset, Form::nothing},
};

constexpr auto command_names = [] {
  std::array<std::string_view, entries.size()> names;
  for (std::size_t i = 0; i < entries.size(); ++i) names[i] = entries[i].name;
  return names;
}();

/// Perfect hash of a command's name.
constexpr std::size_t places = 128;
constexpr std::size_t place_of(std::string_view name) {
  const auto letter = [&](std::size_t at) { return static_cast<unsigned char>(name[at]); };
  return (name.size() + letter(1) + 4U * letter(name.size() - 2)) % places;
}

/// Hash table of command numbers, from 1; 0: empty.
constexpr auto table = [] {
  std::array<std::uint8_t, places> numbers{};
  for (std::size_t i = 0; i < entries.size(); ++i)
    numbers[place_of(entries[i].name)] = static_cast<std::uint8_t>(i + 1);
  return numbers;
}();
static_assert(std::count(table.begin(), table.end(), 0) == places - entries.size(), "two commands share a place");

const Entry* find(std::string_view name) {
  const std::size_t number = name.size() < 2 ? 0 : table[place_of(name)];
  return number > 0 && entries[number - 1].name == name ? &entries[number - 1] : nullptr;
}

/// The words of a line, between blanks; at most five, because no command has more than four.
struct Words {
  std::array<std::string_view, 5> word;
  std::size_t count = 0;
};

Words words_of(std::string_view line) {
  Words words;
  std::size_t begin = 0;
  while (words.count < words.word.size() && (begin = line.find_first_not_of(' ', begin)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    words.word[words.count++] = line.substr(begin, end - begin);
    begin = end;
  }
  return words;
}

/// Parses a 32-bit whole number with an optional sign and surrounding white space; nullopt if it is none.
std::optional<int> whole_number(std::string_view word) {
  constexpr std::string_view blanks = "\t\v\f\r ";
  word.remove_prefix(std::min(word.find_first_not_of(blanks), word.size()));
  word.remove_suffix(word.size() - (word.find_last_not_of(blanks) + 1));
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return parse_whole<int>(word);
}

char lower(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter; }

bool alike(char a, char b) { return lower(a) == lower(b); }

/// Number of letters between the common prefix and the common suffix of two words.
std::size_t difference(std::string_view a, std::string_view b) {
  const auto front = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), alike).first - a.begin();
  a.remove_prefix(static_cast<std::size_t>(front));
  b.remove_prefix(static_cast<std::size_t>(front));
  const auto back = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend(), alike).first - a.rbegin();
  return std::max(a.size(), b.size()) - static_cast<std::size_t>(back);
}

/// "; did you mean NAME?" with the most similar name; empty if none is similar.
std::string suggestion(std::string_view word, std::span<const std::string_view> names) {
  constexpr std::size_t most = 2;  // letters: more is another word
  const auto nearest = std::min_element(names.begin(), names.end(), [&](std::string_view a, std::string_view b) {
    return difference(word, a) < difference(word, b);
  });
  if (difference(word, *nearest) > most) return {};
  return "; did you mean " + std::string(*nearest) + "?";
}

constexpr std::string_view sides = "nesw";

// Each of these parses the arguments of a command. Returns the problem; empty if there is none.

std::string read_nothing(const Entry& entry, const Words& words) {
  return words.count == 1 ? "" : std::string(entry.name) + " takes no argument";
}

std::string read_number(const Entry& entry, const Words& words, MmsCommand& command) {
  if (words.count > 2) return std::string(entry.name) + " takes at most one number";
  // As in mms, an invalid number is 0.
  const std::int64_t number = words.count == 2 ? whole_number(words.word[1]).value_or(0) : 1;
  command.half_steps = entry.form == Form::cells ? 2 * number : number;
  return {};
}

std::string read_statistic(const Words& words, MmsCommand& command) {
  if (words.count != 2) return "getStat takes the name of a statistic";
  command.text = words.word[1];
  const auto names = statistic_names();
  if (std::find(names.begin(), names.end(), command.text) != names.end()) return {};
  return "there is no such statistic";
}

std::string read_cell(std::string_view x, std::string_view y, MmsCommand& command) {
  const auto column = whole_number(x), row = whole_number(y);
  if (!column || !row) return "X and Y must be whole numbers";
  command.x = *column;
  command.y = *row;
  return {};
}

std::string read_drawing(const Entry& entry, const Words& words, MmsCommand& command) {
  const std::string_view third = entry.form == Form::wall ? " D" : entry.form == Form::colour ? " C" : "";
  if (words.count != (third.empty() ? 3U : 4U)) return std::string(entry.name) + " takes X Y" + std::string(third);
  if (std::string problem = read_cell(words.word[1], words.word[2], command); !problem.empty()) return problem;
  if (third.empty()) return {};
  const std::string_view letters = entry.form == Form::wall ? sides : mms_colours;
  const std::string_view letter = words.word[3];
  const std::size_t place = letter.size() == 1 ? letters.find(letter) : std::string_view::npos;
  if (place == std::string_view::npos)
    return std::string(third.substr(1)) + " must be one of the letters " + std::string(letters);
  command.side = static_cast<Heading>(place & 3U);
  command.colour = letter[0];
  return {};
}

/// The text is the rest of the line after the third blank; with only two blanks, mms takes the whole line.
std::string read_text(std::string_view line, MmsCommand& command) {
  constexpr const char* form = "setText takes X Y TEXT, each after a single space";
  const std::size_t first = line.find(' '), second = line.find(' ', first + 1);
  if (line.substr(0, first) != "setText" || first == std::string_view::npos || second == std::string_view::npos)
    return form;
  const std::size_t third = line.find(' ', second + 1);
  const std::string_view x = line.substr(first + 1, second - first - 1);
  const std::string_view y = line.substr(second + 1, std::min(third, line.size()) - second - 1);
  command.text = third == std::string_view::npos ? line : line.substr(third + 1);
  return x.empty() || y.empty() ? form : read_cell(x, y, command);
}

std::string read_arguments(const Entry& entry, const Words& words, std::string_view line, MmsCommand& command) {
  switch (entry.form) {
    case Form::nothing:
      return read_nothing(entry, words);
    case Form::cells:
    case Form::half_steps:
      return read_number(entry, words, command);
    case Form::statistic:
      return read_statistic(words, command);
    case Form::wall:
    case Form::colour:
    case Form::cell:
      return read_drawing(entry, words, command);
    case Form::text:
      break;
  }
  return read_text(line, command);
}

}  // namespace

MmsLine read_mms_line(std::string_view line) {
  const Words words = words_of(line);
  if (words.count == 0) return {{}, "has no reply: the line is empty"};
  const Entry* entry = find(words.word[0]);
  if (entry == nullptr) return {{}, "has no reply: there is no such command"};
  MmsCommand command;
  command.verb = entry->verb;
  command.eighths = entry->eighths;
  const std::string problem = read_arguments(*entry, words, line, command);
  if (problem.empty()) return {command, {}};
  return {{}, (entry->verb < MmsVerb::set_wall ? "has no reply: " : "is ignored: ") + problem};
}

std::string mms_suggestion(std::string_view line) {
  const Words words = words_of(line);
  if (words.count == 0) return {};
  const Entry* entry = find(words.word[0]);
  if (entry == nullptr) return suggestion(words.word[0], command_names);
  return entry->form == Form::statistic && words.count == 2 ? suggestion(words.word[1], statistic_names()) : "";
}

}  // namespace labmouse
