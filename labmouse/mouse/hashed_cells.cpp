#include "labmouse/mouse/hashed_cells.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace labmouse {

namespace {

constexpr std::size_t smallest_table = 8;

/// The smallest table length above so many slots.
constexpr std::size_t table_for(std::size_t slots) { return std::max(smallest_table, std::bit_ceil(slots + 1)); }

}  // namespace

CellOrder cell_order(std::string_view name) {
  const auto found = std::find(cell_order_names.begin(), cell_order_names.end(), name);
  assert(found != cell_order_names.end());
  return static_cast<CellOrder>(found - cell_order_names.begin());
}

/// No table ever grows beyond the least power of two above four times its members, in any version.
HashedCells::HashedCells(Size size, CellOrder order, CellTable table, CellKey key)
    : size_(size),
      order_(order),
      table_(table),
      key_(key),
      slots_(table_for(4 * static_cast<std::size_t>(size.area()))),
      old_slots_(slots_.size()) {
  clear();
}

void HashedCells::clear() {
  // Row by row, every cell has a slot of its own.
  mask_ = (order_ == CellOrder::rows ? table_for(static_cast<std::size_t>(size_.area())) : smallest_table) - 1;
  members_ = used_ = 0;
  std::fill_n(slots_.begin(), mask_ + 1, Slot{});
}

void HashedCells::copy(std::span<const Cell> other) {
  assert(table_ == CellTable::set);
  clear();
  // A copy reserves room for all members at once, half as much as insertion does.
  if (order_ != CellOrder::rows && 3 * other.size() >= 2 * smallest_table) {
    mask_ = table_for(2 * other.size()) - 1;
    std::fill_n(slots_.begin(), mask_ + 1, Slot{});
  }
  for (const Cell cell : other) slot_of(cell) = {cell, State::taken};
  members_ = used_ = other.size();
}

/// Python's hash of a pair of small numbers, each of which is its own hash.
std::uint64_t HashedCells::hash(Cell cell) const {
  if (order_ == CellOrder::rows) return static_cast<std::uint64_t>(size_.index(cell));
  const bool row_first = key_ == CellKey::row_column;
  const int first = row_first ? size_.height - 1 - cell.y : cell.x, second = row_first ? cell.x : cell.y;
  std::uint64_t hash = 0x345678;
  hash = (hash ^ static_cast<std::uint64_t>(first)) * 1000003;
  hash = (hash ^ static_cast<std::uint64_t>(second)) * (1000003 + 82522);
  return hash + 97531;
}

/// The sets of 3.4 probe nine more slots and wrap around the table's end; those of 3.5 do so only where nine are left.
std::uint64_t HashedCells::neighbours(std::uint64_t slot) const {
  constexpr std::uint64_t most = 9;
  if (table_ == CellTable::map || order_ == CellOrder::python_2_7) return 0;
  return order_ == CellOrder::python_3_4 || slot + most <= mask_ ? most : 0;
}

HashedCells::Slot& HashedCells::slot_of(Cell cell) {
  std::uint64_t probe = hash(cell), perturbation = probe;
  Slot* reusable = nullptr;
  while (true) {
    for (std::uint64_t away = 0, most = neighbours(probe & mask_); away <= most; ++away) {
      Slot& slot = slots_[static_cast<std::size_t>((probe + away) & mask_)];
      if (slot.state == State::never_used) return reusable != nullptr ? *reusable : slot;
      if (slot.state == State::taken && slot.cell == cell) return slot;
      if (slot.state == State::erased && reusable == nullptr) reusable = &slot;
    }
    // The sets of Python 3 shift the perturbation before they use it, all other tables after.
    const bool shifts_before = table_ == CellTable::set && order_ != CellOrder::python_2_7;
    if (shifts_before) perturbation >>= 5;
    probe = 5 * probe + perturbation + 1;
    if (!shifts_before) perturbation >>= 5;
  }
}

void HashedCells::insert(Cell cell) {
  Slot* slot = &slot_of(cell);
  if (slot->state == State::taken) return;
  const bool uses_a_slot = slot->state == State::never_used;
  const bool grows_before =
      table_ == CellTable::map && (order_ == CellOrder::python_3_4 || order_ == CellOrder::python_3_5);
  if (uses_a_slot && grows_before && make_room_before()) slot = &slot_of(cell);
  *slot = {cell, State::taken};
  ++members_;
  if (uses_a_slot) ++used_;
  if (!grows_before && order_ != CellOrder::rows) make_room_after();
}

/// The maps of Python 3 rebuild their table when the next member would take it beyond two thirds; whether it did.
bool HashedCells::make_room_before() {
  const std::size_t length = mask_ + 1;
  if (used_ < (2 * length + 1) / 3) return false;
  rebuild(table_for(2 * members_ + length / 2));
  return true;
}

/// The maps of 2.7, and all sets, do so when the last member has taken it to two thirds.
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
