#include "labmouse/mouse/distance.hpp"

#include <bit>
#include <cassert>
#include <cstring>

#include "labmouse/mouse/distance_kernel.hpp"

namespace labmouse {
namespace {

int row_bits_for(Size size) {
  const int side = size.width > size.height ? size.width : size.height;
  return side <= 16 ? 16 : side <= 32 ? 32 : 64;
}

/// Words of 64 bits in a set of as many rows as a row has bits.
int words_in_set(int row_bits) { return row_bits * row_bits / 64; }

Kernel choose_kernel([[maybe_unused]] DistanceField::Path path, int row_bits, const Motion& motion) {
#if defined(LABMOUSE_WIDE)
  if (path == DistanceField::Path::widest && __builtin_cpu_supports("avx2") != 0)
    return wide::kernel_for(row_bits, motion.longest, motion.uniform());
#endif
  return portable::kernel_for(row_bits, motion.longest, motion.uniform());
}

}  // namespace

DistanceField::DistanceField(Size size, const Motion& motion, Path path)
    : size_(size), motion_(motion), row_bits_(row_bits_for(size)) {
  assert(size.valid() && motion.valid());
  const int dearest = motion.cost[static_cast<unsigned>(motion.longest)];
  // The distance is counted on for one round of the ring after the last cell was reached.
  planes_ = std::bit_width(static_cast<unsigned>((size.area() + 2) * dearest));
  kernel_ = choose_kernel(path, row_bits_, motion);
  const int sets = 1 + planes_ + dearest + 1;  // the last ones are the ring of the kernel for any costs
  constexpr int words_in_block = sizeof(Block) / sizeof(std::uint64_t);
  storage_.resize(static_cast<std::size_t>((sets * words_in_set(row_bits_) + words_in_block - 1) / words_in_block));
}

void DistanceField::fill(const WallSet& passages, const CellSet& from) {
  kernel_({passages.north().rows(), passages.east().rows(), from.rows(), sets(), planes_, motion_.longest,
           motion_.cost.data()});
}

template <class Word>
int DistanceField::read(Cell cell) const {
  constexpr std::size_t bytes_in_set = 8 * sizeof(Word) * sizeof(Word);
  const unsigned char* row =
      reinterpret_cast<const unsigned char*>(sets()) + static_cast<unsigned>(cell.y) * sizeof(Word);
  const auto bit = [&](int set) {
    Word word;
    std::memcpy(&word, row + static_cast<std::size_t>(set) * bytes_in_set, sizeof word);
    return static_cast<int>(word >> cell.x & 1U);
  };
  if (bit(0) != 0) return unreachable;
  int distance = 0;
  for (int plane = 0; plane < planes_; ++plane) distance |= bit(1 + plane) << plane;
  return distance;
}

int DistanceField::at(Cell cell) const {
  if (!size_.contains(cell)) return unreachable;
  if (row_bits_ == 16) return read<std::uint16_t>(cell);
  if (row_bits_ == 32) return read<std::uint32_t>(cell);
  return read<std::uint64_t>(cell);
}

template <class Word>
void DistanceField::read_all(std::span<int> out) const {
  for (int index = 0; index < size_.area(); ++index)
    out[static_cast<std::size_t>(index)] = read<Word>(size_.cell_at(index));
}

template <class Word>
CellSet DistanceField::read_reached() const {
  CellSet cells;
  const CellSet all = CellSet::all(size_);
  const unsigned char* rows = reinterpret_cast<const unsigned char*>(sets());
  for (int y = 0; y < size_.height; ++y) {
    Word unreached;
    std::memcpy(&unreached, rows + static_cast<unsigned>(y) * sizeof(Word), sizeof unreached);
    cells.set_row(y, all.row(y) & ~static_cast<std::uint64_t>(unreached));
  }
  return cells;
}

CellSet DistanceField::reached() const {
  if (row_bits_ == 16) return read_reached<std::uint16_t>();
  if (row_bits_ == 32) return read_reached<std::uint32_t>();
  return read_reached<std::uint64_t>();
}

void DistanceField::copy_to(std::span<int> out) const {
  assert(out.size() == static_cast<std::size_t>(size_.area()));
  if (row_bits_ == 16)
    read_all<std::uint16_t>(out);
  else if (row_bits_ == 32)
    read_all<std::uint32_t>(out);
  else
    read_all<std::uint64_t>(out);
}

}  // namespace labmouse
