// What the text formats share: lines, words and numbers, each with its place in the file.
//
// All of them accept line ends of LF and CRLF, a byte order mark, a missing last line end, and blanks (spaces and tabs)
// behind a line or blank lines behind the last one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace labmouse::formats {

/// Texts and whole numbers in a row. This part of the library needs no other one.
template <class... Parts>
std::string joined(const Parts&... parts) {
  std::string text;
  const auto add = [&](const auto& part) {
    if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(part)>>)
      text += std::to_string(part);
    else
      text += part;
  };
  (add(parts), ...);
  return text;
}

inline constexpr std::string_view blanks = " \t";

/// One line without its line end and trailing blanks. Its number counts from 1, and so do columns, in bytes; a byte
/// order mark is not counted.
struct Line {
  int number = 0;
  std::string_view text;

  /// The column behind the last character.
  int end() const { return static_cast<int>(text.size()) + 1; }
};

/// A piece of a line, and the column of its first character.
struct Word {
  std::string_view text;
  int column = 0;
};

/// Whether there is nothing but blanks and line ends, and perhaps a byte order mark.
bool is_blank(std::string_view content);

/// The first line; empty when there is none.
std::string_view first_line(std::string_view content);

/// The lines up to the last that is not blank, but at most `most`. A reader that asks for one more than its format
/// allows detects excess lines, and never stores more.
std::vector<Line> lines_of(std::string_view content, std::size_t most);

/// Whether a line has digits, and nothing else but signs, commas and blanks.
bool has_only_numbers(std::string_view line);

/// The pieces between blanks, but no more than `most`.
std::vector<Word> words_between_blanks(std::string_view text, std::size_t most);

/// The pieces between commas, without the blanks around them, possibly empty; but no more than `most`.
std::vector<Word> words_between_commas(std::string_view text, std::size_t most);

/// The number that the digits give; nothing if it is none, or not from `least` to `most` (0 <= least).
std::optional<int> number_of(std::string_view digits, int least, int most);

}  // namespace labmouse::formats
