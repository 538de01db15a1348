#include "labmouse/mouse/hashed_cells.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace labmouse {

namespace {

constexpr std::size_t smallest_table = 8;

/// A table is rebuilt for four times its members, so that much is the most it ever needs.
constexpr std::size_t table_for(std::size_t members) {
  return std::max(smallest_table, std::bit_ceil(4 * members + 1));
}

}  // namespace

HashedCells::HashedCells(Size size)
    : height_(size.height), slots_(table_for(static_cast<std::size_t>(size.area()))), old_slots_(slots_.size()) {
  clear();
}

void HashedCells::clear() {
  mask_ = smallest_table - 1;
  members_ = used_ = 0;
  std::fill_n(slots_.begin(), smallest_table, Slot{});
}

/// The hash of a pair of small numbers, each of which is its own hash.
std::uint64_t HashedCells::hash(Cell cell) const {
  std::uint64_t hash = 0x345678;
  hash = (hash ^ static_cast<std::uint64_t>(height_ - 1 - cell.y)) * 1000003;
  hash = (hash ^ static_cast<std::uint64_t>(cell.x)) * (1000003 + 82522);
  return hash + 97531;
}

HashedCells::Slot& HashedCells::slot_of(Cell cell) {
  std::uint64_t probe = hash(cell), perturbation = probe;
  Slot* reusable = nullptr;
  while (true) {
    Slot& slot = slots_[static_cast<std::size_t>(probe & mask_)];
    if (slot.state == State::never_used) return reusable != nullptr ? *reusable : slot;
    if (slot.state == State::taken && slot.cell == cell) return slot;
    if (slot.state == State::erased && reusable == nullptr) reusable = &slot;
    probe = 5 * probe + perturbation + 1;
    perturbation >>= 5;
  }
}

void HashedCells::insert(Cell cell) {
  Slot& slot = slot_of(cell);
  if (slot.state == State::taken) return;
  if (slot.state == State::never_used) ++used_;
  slot = {cell, State::taken};
  ++members_;
  if (3 * used_ >= 2 * (mask_ + 1)) rebuild();
}

void HashedCells::erase(Cell cell) {
  Slot& slot = slot_of(cell);
  if (slot.state != State::taken) return;
  slot.state = State::erased;
  --members_;
}

void HashedCells::rebuild() {
  const std::size_t old_length = mask_ + 1;
  std::swap(slots_, old_slots_);
  mask_ = table_for(members_) - 1;
  assert(mask_ < slots_.size());
  used_ = members_;
  std::fill_n(slots_.begin(), mask_ + 1, Slot{});
  for (std::size_t i = 0; i < old_length; ++i)
    if (old_slots_[i].state == State::taken) slot_of(old_slots_[i].cell) = old_slots_[i];
}

}  // namespace labmouse
