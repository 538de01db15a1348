#include "labmouse/lab/mazes/maze_link.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
static_assert(digits.size() == max_side, "a coordinate is one digit");
constexpr std::string_view hex_digits = "0123456789ABCDEF";
constexpr std::string_view heading_letters = "nesw";
constexpr std::string_view link_version = "1";
constexpr std::string_view centre = "c";
constexpr std::size_t checksum_digits = 6;

enum Part : std::size_t {
  version_part,
  size_part,
  start_part,
  goals_part,
  walls_part,
  name_part,
  checksum_part,
  parts
};
constexpr std::array<std::string_view, parts> part_names = {"version", "size", "start",   "goals",
                                                            "walls",   "name", "checksum"};

/// FNV-1a: a single changed character always changes it.
std::string checksum_of(std::string_view text) {
  std::uint32_t hash = 0x811C9DC5U;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x01000193U;
  std::string sum;
  for (std::size_t i = 0; i < checksum_digits; ++i, hash >>= 6U) sum += digits[hash & 63U];
  return sum;
}

std::string cell_text(Cell cell) {
  return {digits[static_cast<std::size_t>(cell.x)], digits[static_cast<std::size_t>(cell.y)]};
}

/// The cell of two digits; (-1,-1) if they are not digits.
Cell read_cell(std::string_view text) {
  const auto x = digits.find(text[0]), y = digits.find(text[1]);
  if (x == std::string_view::npos || y == std::string_view::npos) return {-1, -1};
  return {static_cast<int>(x), static_cast<int>(y)};
}

std::string goals_text(const Maze& maze) {
  if (maze.goals() == centre_of(maze.size())) return std::string(centre);
  std::string text;
  maze.goals().for_each([&](Cell cell) { text += cell_text(cell); });
  return text;
}

/// The goals; empty if the text has none, or one outside of the maze.
CellSet read_goals(std::string_view text, Size size) {
  if (text == centre) return centre_of(size);
  CellSet goals;
  if (text.size() % 2 != 0) return goals;
  for (; !text.empty(); text.remove_prefix(2)) {
    const Cell cell = read_cell(text);
    if (!size.contains(cell)) return {};
    goals.insert(cell);
  }
  return goals;
}

std::string walls_text(const Maze& maze) {
  std::string text;
  std::size_t bits = 0;
  unsigned digit = 0;
  WallSet::all(maze.size()).for_each([&](Wall wall) {
    digit = digit << 1U | (maze.open_walls().contains(wall) ? 0U : 1U);
    if (++bits % 6 == 0) text += digits[std::exchange(digit, 0)];
  });
  if (bits % 6 != 0) text += digits[digit << (6 - bits % 6)];
  return text;
}

/// Opens the walls that are open in the text; returns false for a wrong length or an invalid character.
bool read_walls(std::string_view text, MazeDraft& draft) {
  const WallSet walls = WallSet::all(draft.size());
  if (text.size() != (static_cast<std::size_t>(walls.count()) + 5) / 6) return false;
  if (text.find_first_not_of(digits) != std::string_view::npos) return false;
  std::size_t bits = 0;
  walls.for_each([&](Wall wall) {
    const auto digit = digits.find(text[bits / 6]);
    if ((digit >> (5 - bits % 6) & 1U) == 0) draft.open(wall.cell, wall.side);
    ++bits;
  });
  return true;
}

bool plain(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
         letter == '-';
}

/// The end of a name that is too long, from the beginning of a UTF-8 character (continuation bytes begin with the bits
/// 10).
std::string_view short_name(std::string_view name) {
  if (name.size() <= longest_link_name) return name;
  name.remove_prefix(name.size() - longest_link_name);
  std::size_t broken = 0;
  while (broken < 3 && (static_cast<unsigned char>(name[broken]) & 0xC0U) == 0x80U) ++broken;
  return name.substr(broken);
}

std::string name_text(std::string_view name) {
  std::string text;
  for (const char letter : short_name(name)) {
    const auto byte = static_cast<unsigned char>(letter);
    if (plain(letter))
      text += letter;
    else
      text.append({'_', hex_digits[byte >> 4U], hex_digits[byte & 15U]});
  }
  return text;
}

std::optional<std::string> read_name(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '_') {
      name += text[i];
      continue;
    }
    if (text.size() - i < 3) return std::nullopt;
    const auto high = hex_digits.find(text[i + 1]), low = hex_digits.find(text[i + 2]);
    if (high == std::string_view::npos || low == std::string_view::npos) return std::nullopt;
    name += static_cast<char>(high << 4U | low);
    i += 2;
  }
  return name;
}

/// The size of a text such as `16x16`; an invalid size for other texts.
Size read_size(std::string_view text) {
  const auto width = take_whole<int>(text);
  if (!width || !text.starts_with('x')) return {};
  const auto height = parse_whole<int>(text.substr(1));
  return height ? Size{*width, *height} : Size{};
}

/// Splits a link at its dots into at most `parts` parts; the last one is the whole remainder.
std::array<std::string_view, parts> parts_of(std::string_view link, std::size_t& count) {
  std::array<std::string_view, parts> found;
  for (count = 0; count < parts; ++count) {
    const auto end = count + 1 < parts ? link.find('.') : std::string_view::npos;
    found[count] = link.substr(0, end);
    if (end == std::string_view::npos) return ++count, found;
    link.remove_prefix(end + 1);
  }
  return found;
}

/// Checks version, number of parts and checksum; returns the error, or an empty text.
std::string wrong_form(std::string_view link) {
  if (link.empty()) return "the link is empty";
  std::size_t count = 0;
  const auto found = parts_of(link, count);
  const std::string_view first = found[version_part];
  if (first.empty() || first.find_first_not_of("0123456789") != std::string_view::npos)
    return "this is not a link to a maze";
  if (first != link_version)
    return fmt::format("the link has version {}, but this program knows only version {}", first.substr(0, 9),
                       link_version);
  if (count < parts) return fmt::format("the link is incomplete: it breaks off in its {}", part_names[count - 1]);
  const std::string_view sum = found[checksum_part];
  if (sum.size() < checksum_digits) return "the link is incomplete: it breaks off in its checksum";
  if (sum.size() > checksum_digits) return "the link is damaged: it continues after its checksum";
  if (sum != checksum_of(link.substr(0, link.size() - sum.size())))
    return "the link is damaged: its checksum does not match";
  return "";
}

std::optional<NamedMaze> maze_of(const std::array<std::string_view, parts>& found) {
  const Size size = read_size(found[size_part]);
  const std::string_view start = found[start_part];
  if (!size.valid() || start.size() != 3) return std::nullopt;
  MazeDraft draft(size, MazeDraft::Inside::closed);
  const auto heading = heading_letters.find(start[2]);
  const Cell cell = read_cell(start);
  const CellSet goals = read_goals(found[goals_part], size);
  const auto name = read_name(found[name_part]);
  if (heading == std::string_view::npos || !size.contains(cell) || goals.empty() || !name) return std::nullopt;
  if (!read_walls(found[walls_part], draft)) return std::nullopt;
  draft.set_start(cell, all_headings[heading]);
  goals.for_each([&](Cell goal) { draft.add_goal(goal); });
  return NamedMaze{*name, Maze(draft)};
}

}  // namespace

std::string link_of(const NamedMaze& maze) {
  const Size size = maze.maze.size();
  std::string link =
      fmt::format("{}.{}x{}.{}{}.{}.{}.{}.", link_version, size.width, size.height, cell_text(maze.maze.start()),
                  heading_letters[static_cast<std::size_t>(maze.maze.start_heading())], goals_text(maze.maze),
                  walls_text(maze.maze), name_text(maze.name));
  return link + checksum_of(link);
}

ReadLinkResult read_link(std::string_view link) {
  if (std::string error = wrong_form(link); !error.empty()) return {std::nullopt, std::move(error)};
  std::size_t count = 0;
  auto maze = maze_of(parts_of(link, count));
  // Each maze has exactly one link: refuse other spellings, even with the right checksum.
  if (!maze || link_of(*maze) != link) return {std::nullopt, "the link does not hold a valid maze"};
  return {std::move(maze), ""};
}

}  // namespace labmouse
