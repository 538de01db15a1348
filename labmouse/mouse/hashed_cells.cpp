#include "labmouse/mouse/hashed_cells.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace labmouse {

namespace {

constexpr std::size_t smallest_table = 8;

/// The least table that is longer than so many slots.
constexpr std::size_t table_for(std::size_t slots) { return std::max(smallest_table, std::bit_ceil(slots + 1)); }

}  // namespace

/// No table ever grows beyond the least power of two above four times its members, in neither version.
HashedCells::HashedCells(Size size, Python version, CellKey key)
    : size_(size),
      version_(version),
      key_(key),
      slots_(table_for(4 * static_cast<std::size_t>(size.area()))),
      old_slots_(slots_.size()) {
  clear();
}

void HashedCells::clear() {
  mask_ = smallest_table - 1;
  members_ = used_ = 0;
  std::fill_n(slots_.begin(), smallest_table, Slot{});
}

/// The hash of a pair of small numbers, each of which is its own hash.
std::uint64_t HashedCells::hash(Cell cell) const {
  const bool row_first = key_ == CellKey::row_column;
  const int first = row_first ? size_.height - 1 - cell.y : cell.x, second = row_first ? cell.x : cell.y;
  std::uint64_t hash = 0x345678;
  hash = (hash ^ static_cast<std::uint64_t>(first)) * 1000003;
  hash = (hash ^ static_cast<std::uint64_t>(second)) * (1000003 + 82522);
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
  Slot* slot = &slot_of(cell);
  if (slot->state == State::taken) return;
  const bool uses_a_slot = slot->state == State::never_used;
  if (uses_a_slot && version_ == Python::v3_5 && make_room_before()) slot = &slot_of(cell);
  *slot = {cell, State::taken};
  ++members_;
  if (uses_a_slot) ++used_;
  if (version_ == Python::v2_7) make_room_after();
}

/// 3.5 rebuilds its table when the next member would take it beyond two thirds; whether it did.
bool HashedCells::make_room_before() {
  const std::size_t length = mask_ + 1;
  if (used_ < (2 * length + 1) / 3) return false;
  rebuild(table_for(2 * members_ + length / 2));
  return true;
}

/// 2.7 rebuilds its table when the last member has taken it to two thirds.
void HashedCells::make_room_after() {
  if (3 * used_ >= 2 * (mask_ + 1)) rebuild(table_for(4 * members_));
}

void HashedCells::erase(Cell cell) {
  Slot& slot = slot_of(cell);
  if (slot.state != State::taken) return;
  slot.state = State::erased;
  --members_;
}

void HashedCells::rebuild(std::size_t length) {
  const std::size_t old_length = mask_ + 1;
  std::swap(slots_, old_slots_);
  mask_ = length - 1;
  assert(mask_ < slots_.size());
  used_ = members_;
  std::fill_n(slots_.begin(), length, Slot{});
  for (std::size_t i = 0; i < old_length; ++i)
    if (old_slots_[i].state == State::taken) slot_of(old_slots_[i].cell) = old_slots_[i];
}

}  // namespace labmouse
