#include "labmouse/maze/formats/step_line.hpp"

#include <algorithm>
#include <cctype>

#include "labmouse/maze/formats/text.hpp"

namespace labmouse::formats {
namespace {

std::optional<Heading> heading_of(std::string_view word) {
  for (const Heading heading : all_headings) {
    const std::string_view name = labmouse::name_of(heading);
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    if ((word.size() == 1 || word.size() == name.size()) && std::equal(word.begin(), word.end(), name.begin(), same))
      return heading;
  }
  return std::nullopt;
}

bool are_walls(std::string_view word) {
  return (word.size() == 3 || word.size() == 4) && word.find_first_not_of("01?") == std::string_view::npos;
}

/// The walls of three letters are those on the left, ahead and on the right; of four, those in the north and clockwise.
std::array<std::optional<bool>, 4> walls_of(std::string_view word, Heading heading) {
  std::array<std::optional<bool>, 4> closed;
  const Heading first = word.size() == 3 ? left_of(heading) : Heading::north;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (word[i] != '?') closed[static_cast<std::size_t>(turned(first, static_cast<int>(i)))] = word[i] == '1';
  return closed;
}

struct Piece {
  std::string_view before;  ///< what stands between the last word and this one
  std::string_view word;
};

Piece take_word(std::string_view& rest) {
  const auto is_word = [](char letter) {
    return letter == '?' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
  };
  const auto begin = static_cast<std::size_t>(std::find_if(rest.begin(), rest.end(), is_word) - rest.begin());
  const std::string_view before = rest.substr(0, begin);
  rest.remove_prefix(begin);
  const auto end = static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), is_word) - rest.begin());
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end);
  return {before, word};
}

}  // namespace

std::optional<StepLine> read_step_line(std::string_view line) {
  std::optional<int> before, last;  // numbers
  std::optional<Heading> heading;
  bool blanks_alone = true;
  int words = 0;
  while (!line.empty()) {
    const Piece piece = take_word(line);
    ++words;
    blanks_alone &= piece.before.find_first_not_of(" \t,;") == std::string_view::npos;
    if (heading) {
      if (are_walls(piece.word))
        return StepLine{{*before, *last}, *heading, walls_of(piece.word, *heading), blanks_alone && words == 4, line};
    } else if (const auto number = number_of(piece.word, 0, 1'000'000'000)) {
      // A cell outside of the maze is none inside of it.
      const bool negative = piece.before.ends_with('-');
      before = last, last = negative ? std::nullopt : number;
    } else if (before && last && *before < max_side && *last < max_side) {
      heading = heading_of(piece.word);
    }
  }
  return std::nullopt;
}

}  // namespace labmouse::formats
