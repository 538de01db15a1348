#include "labmouse/mouse/drive/lattice.hpp"

namespace labmouse::drive {
namespace {

/// Bit i of the lower half goes to bit 2i.
std::uint32_t spread(std::uint64_t bits, std::uint32_t) {
  auto word = static_cast<std::uint32_t>(bits & 0xffffU);
  word = (word | word << 8U) & 0x00ff00ffU;
  word = (word | word << 4U) & 0x0f0f0f0fU;
  word = (word | word << 2U) & 0x33333333U;
  return (word | word << 1U) & 0x55555555U;
}
std::uint64_t spread(std::uint64_t bits, std::uint64_t) {
  std::uint64_t word = bits & 0xffffffffU;
  word = (word | word << 16U) & 0x0000ffff0000ffffU;
  word = (word | word << 8U) & 0x00ff00ff00ff00ffU;
  word = (word | word << 4U) & 0x0f0f0f0f0f0f0f0fU;
  word = (word | word << 2U) & 0x3333333333333333U;
  return (word | word << 1U) & 0x5555555555555555U;
}

/// Transposes a square of bits: bit x of word y becomes bit y of word x. By halves (Hacker's Delight, 7-3).
template <class Word>
void transpose(Word* words) {
  constexpr int size = 8 * sizeof(Word);
  Word mask = static_cast<Word>(~Word{0}) >> (size / 2);
  for (int half = size / 2; half != 0; half /= 2, mask ^= mask << half)
    for (int block = 0; block < size; block += 2 * half)
      for (int i = block; i < block + half; ++i) {
        const Word swapped = ((words[i] >> half) ^ words[i + half]) & mask;
        words[i + half] ^= swapped;
        words[i] ^= swapped << half;
      }
}

template <class Word>
constexpr Word odd_bits = static_cast<Word>(0xaaaaaaaaaaaaaaaaU);

/// Bit x goes to bit size - x; bit 0, which is no point, gets lost.
template <class Word>
Word mirrored(Word word) {
  constexpr int size = 8 * sizeof(Word);
  Word mask = static_cast<Word>(~Word{0});
  for (int half = size / 2; half != 0; half /= 2) {
    mask ^= mask << half;
    word = ((word >> half) & mask) | ((word << half) & ~mask);
  }
  return word << 1;
}

}  // namespace

template <class Word>
void Lattice<Word>::build(Size size, const WallSet& passages) {
  const Word cells = spread(~std::uint64_t{0} >> (64 - size.width), Word{}) << 1;
  for (int y = 0; y < lines; ++y) {
    const bool inside = y < size.height;
    rows_[margin + 2 * y + 1] = inside ? cells | spread(passages.east().row(y), Word{}) << 1 << 1 : 0;
    if (2 * y + 2 < points) rows_[margin + 2 * y + 2] = inside ? spread(passages.north().row(y), Word{}) << 1 : 0;
  }
  // Lines of all four kinds, and the same from their other ends; straight ones have empty lines on both sides.
  Word* const rows = rows_ + margin;
  Word* const columns = columns_ + margin;
  Word rising[points], falling[points];
  Word back_rows[points + 2 * margin]{}, back_columns[points + 2 * margin]{}, back_rising[points], back_falling[points];
  for (int y = 0; y < points; ++y) {
    columns[y] = rows[y];
    rising[y] = std::rotr(rows[y], y);
    falling[y] = std::rotl(rows[y], y);
  }
  transpose(columns);
  transpose(rising);
  transpose(falling);
  for (int i = 0; i < points; ++i) {
    back_rows[margin + i] = mirrored(rows[i]);
    back_columns[margin + i] = mirrored(columns[i]);
    back_rising[i] = mirrored(rising[i]);
    back_falling[i] = mirrored(falling[i]);
  }
  find_turns_along(0, columns);
  find_turns_across(1, rising);
  find_turns_along(2, rows);
  find_turns_across(3, back_falling);
  find_turns_along(4, back_columns + margin);
  find_turns_across(5, back_rising);
  find_turns_along(6, back_rows + margin);
  find_turns_across(7, falling);
}

/// The turns of a direction along the axes; the words are the lines in that direction, walls and posts between them.
template <class Word>
void Lattice<Word>::find_turns_along(int direction, const Word* words) {
  // To the right of north and west, the numbers of lines increase.
  const int right = direction == 0 || direction == 6 ? 1 : -1;
  for (int line = 0; line < lines; ++line) {
    const Word* here = words + 2 * line + 1;
    std::array<Word, 8>& turns = turns_[direction * lines + line];
    Word any = 0;
    for (unsigned side = 0; side < 2; ++side) {
      const int aside = side == 0 ? -right : right;
      const Word round = here[0] >> 1 & here[aside] >> 2 & odd_bits<Word>;
      const Word small = here[0] & here[aside] >> 1 & ~odd_bits<Word>;
      const Word back = round & here[2 * aside] >> 1;
      turns[0 + side] = round | small;
      turns[2 + side] = round & here[2 * aside] >> 3;
      turns[4 + side] = back & here[3 * aside];
      turns[6 + side] = back;
      any |= round | small;
    }
    any_turn_[direction * lines + line] = any;
    lines_[direction * lines + line] = here[0];
  }
}

/// The turns of a diagonal direction; the words are the diagonals, of which every second has points.
template <class Word>
void Lattice<Word>::find_turns_across(int direction, const Word* words) {
  // Where a diagonal lies on a wall between north and south, its turn goes to this side.
  const int aside = direction == 1 || direction == 3 ? 2 : -2;
  const auto word = [&](int line) { return words[line & (points - 1)]; };
  for (int line = 1; line < points; line += 2) {
    const Word valid = word(line) & word(line) >> 1;
    const Word third = (word(line + aside) & ~odd_bits<Word>) | (word(line - aside) >> 2 & odd_bits<Word>);
    const Word fourth =
        (word(line + 2 * aside) << 1 & ~odd_bits<Word>) | (word(line - 2 * aside) >> 3 & odd_bits<Word>);
    std::array<Word, 8>& turns = turns_[direction * lines + line / 2];
    turns[diagonal_v90] = valid & third & fourth;
    turns[diagonal_out45] = valid;
    turns[diagonal_out135] = valid & third;
    any_turn_[direction * lines + line / 2] = valid;
    lines_[direction * lines + line / 2] = word(line);
  }
}

template <class Word>
unsigned Lattice<Word>::turns_at(int node) const {
  unsigned bits = 0;
  for (unsigned bit = 0; bit < 8; ++bit) bits |= static_cast<unsigned>(turns(node)[bit] >> (node % points) & 1U) << bit;
  return bits;
}

/// The node where the turn of a bit ends. It is wrong if the turn would leave the maze, but then it is never used.
template <class Word>
int Lattice<Word>::leap(int node, unsigned bit) {
  const int before = direction(node);
  const bool even = node % 2 == 0;
  const int side = leads_left(bit, before, even) ? -1 : 1;
  const Turn turn = turn_of(bit, before % 2 != 0, even);
  // For a diagonal: the directions across the wall that it lies on, and across the next one.
  const HalfPoint ahead = unit(before), across = unit(before + 2 * side + 8);
  const HalfPoint first = unit(before - side + 8), second = unit(before + side + 8);
  const auto moved = [&](int m, HalfPoint a, int n, HalfPoint b) {
    const HalfPoint from = point(node);
    return HalfPoint{(from.x + m * a.x + n * b.x) & (points - 1), (from.y + m * a.y + n * b.y) & (points - 1)};
  };
  const int after = (before + 8 + side * eighths(turn)) & 7;
  switch (turn) {
    case Turn::f45:
      return Lattice::node(moved(2, ahead, 1, across), after);
    case Turn::f90:
      return Lattice::node(moved(2, ahead, 2, across), after);
    case Turn::f135:
      return Lattice::node(moved(1, ahead, 2, across), after);
    case Turn::f180:
      return Lattice::node(moved(0, ahead, 2, across), after);
    case Turn::s90:
    case Turn::v90:
      return Lattice::node(moved(1, ahead, 1, across), after);
    case Turn::out45:
      return Lattice::node(moved(1, first, 2, second), after);
    case Turn::out135:
      return Lattice::node(moved(-1, first, 2, second), after);
  }
  return node;
}

template <class Word>
std::vector<std::uint16_t> Lattice<Word>::leaps() {
  std::vector<std::uint16_t> leaps(8 * static_cast<std::size_t>(nodes));
  for (int node = 0; node < nodes; ++node)
    for (unsigned bit = 0; bit < (direction(node) % 2 == 0 ? 8U : 3U); ++bit)
      leaps[8 * static_cast<std::size_t>(node) + bit] = static_cast<std::uint16_t>(leap(node, bit));
  return leaps;
}

Leaps::Leaps(Size largest) : small(Lattice<std::uint32_t>::leaps()) {
  if (!is_small(largest)) large = Lattice<std::uint64_t>::leaps();
}

template class Lattice<std::uint32_t>;
template class Lattice<std::uint64_t>;

}  // namespace labmouse::drive
