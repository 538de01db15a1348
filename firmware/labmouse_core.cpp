// Behind labmouse_core.h: the strategies as they are on the desktop, in memory of the caller.
#include "labmouse_core.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

#include "labmouse/mouse/route.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace {

using namespace labmouse;

/// What is left of the memory of the mouse that is being made.
struct Arena {
  std::byte* begin;
  std::byte* next;
  std::byte* end;

  void* take(std::size_t bytes, std::size_t alignment) {
    void* place = next;
    std::size_t space = static_cast<std::size_t>(end - next);
    if (std::align(alignment, bytes, place, space) == nullptr) std::abort();  // a test makes every mouse that there is
    next = static_cast<std::byte*>(place) + bytes;
    return place;
  }
};

Arena* arena = nullptr;

void* allocate(std::size_t bytes) {
  if (arena != nullptr) return arena->take(bytes, alignof(std::max_align_t));
  void* memory = std::malloc(bytes > 0 ? bytes : 1);
  if (memory == nullptr) std::abort();
  return memory;
}

// What lies in a mouse is never given back: the caller has the memory.
void give_back(void* memory) {
  if (arena == nullptr) std::free(memory);
}

/// Not every library for chips has aligned_alloc: the pointer of the whole block stands before the part that is used.
void* allocate_aligned(std::size_t bytes, std::size_t alignment) {
  if (arena != nullptr) return arena->take(bytes, alignment);
  void* const whole = allocate(bytes + alignment + sizeof(void*));
  void* part = static_cast<std::byte*>(whole) + sizeof whole;
  std::size_t space = bytes + alignment;
  part = std::align(alignment, bytes, part, space);
  std::memcpy(static_cast<std::byte*>(part) - sizeof whole, &whole, sizeof whole);
  return part;
}

void give_back_aligned(void* part) {
  if (part == nullptr || arena != nullptr) return;
  void* whole;
  std::memcpy(&whole, static_cast<std::byte*>(part) - sizeof whole, sizeof whole);
  give_back(whole);
}

/// While a mouse is made.
class TakesFrom {
 public:
  explicit TakesFrom(Arena& memory) { arena = &memory; }
  ~TakesFrom() { arena = nullptr; }
  TakesFrom(const TakesFrom&) = delete;
  TakesFrom& operator=(const TakesFrom&) = delete;
};

constexpr std::uint32_t is_made = 0x4C4D4331;

constexpr std::array strategies = {&flood_mouse, &flood_return_mouse, &certify_mouse, &ariadne_mouse};

enum class Next : std::uint8_t { first_reading, reading, decision, nothing };

std::uint16_t checksum(const std::uint8_t* bytes, std::size_t count) {
  std::uint16_t sum = 0xFFFF;
  for (std::size_t i = 0; i < count; ++i) {
    sum = static_cast<std::uint16_t>(sum ^ bytes[i] << 8);
    for (int bit = 0; bit < 8; ++bit)
      sum = static_cast<std::uint16_t>((sum & 0x8000U) != 0 ? sum << 1 ^ 0x1021 : sum << 1);
  }
  return sum;
}

}  // namespace

struct labmouse_core {
  labmouse_core(void* start, std::size_t size, const BuiltinMouse& entry_, const Briefing& briefing_)
      : memory(start),
        bytes(size),
        entry(&entry_),
        briefing(briefing_),
        settings(entry_.parameters),
        strategy(entry_.make(briefing, settings)),
        restored(briefing.size, briefing.sight),
        to_goal(briefing.size, briefing.motion),
        pose(briefing.start) {}

  const Knowledge& map() const { return is_restored ? restored : strategy->knowledge(); }

  std::uint32_t made = is_made;
  Next next = Next::first_reading;
  void* memory;
  std::size_t bytes;
  const BuiltinMouse* entry;
  Briefing briefing;
  Settings settings;
  std::unique_ptr<Strategy> strategy;
  Knowledge restored;  ///< a map that was saved: its speed run needs no strategy
  DistanceField to_goal;
  Pose pose;
  Sighting seen;
  bool is_restored = false;
  bool racing = false;
  bool arrived = false;  ///< a step of the speed run has ended in a goal
};

// Both halves stand below, which g++ does not see where it inlines one of them.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

void* operator new(std::size_t bytes) { return allocate(bytes); }
void* operator new[](std::size_t bytes) { return allocate(bytes); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate_aligned(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
  return allocate_aligned(bytes, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return allocate(bytes); }
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept { return allocate(bytes); }
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate_aligned(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate_aligned(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete[](void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { give_back_aligned(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { give_back_aligned(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { give_back_aligned(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { give_back_aligned(memory); }

namespace {

bool is_mouse(const labmouse_core* mouse) { return mouse->made == is_made; }

/// Makes the mouse; what a former one held in the memory is overwritten.
labmouse_core* make_in(void* memory, std::size_t bytes, const BuiltinMouse& entry, const Briefing& briefing) {
  Arena whole{static_cast<std::byte*>(memory), static_cast<std::byte*>(memory),
              static_cast<std::byte*>(memory) + bytes};
  void* place = whole.take(sizeof(labmouse_core), alignof(labmouse_core));
  const TakesFrom here(whole);
  return new (place) labmouse_core(memory, bytes, entry, briefing);
}

labmouse_core_status status_of(ForfeitReason reason) {
  return reason == ForfeitReason::contradiction ? LABMOUSE_CORE_CONTRADICTION : LABMOUSE_CORE_NO_ROUTE;
}

/// The four sets of bits that a map is saved as, row by row.
std::uint64_t row_of(const Knowledge& map, int set, int y) {
  const WallSet& walls = set < 2 ? map.open() : map.possible();
  return set % 2 == 0 ? walls.north().row(y) : walls.east().row(y);
}

constexpr std::size_t head = 5;

std::size_t row_bytes(Size size) { return static_cast<std::size_t>(size.width + 7) / 8; }
std::size_t saved_bytes(Size size) { return head + 4 * static_cast<std::size_t>(size.height) * row_bytes(size) + 2; }

std::array<std::uint8_t, head> head_of(Size size) {
  return {'L', 'C', LABMOUSE_CORE_VERSION, static_cast<std::uint8_t>(size.width),
          static_cast<std::uint8_t>(size.height)};
}

std::uint64_t saved_row(const std::uint8_t* saved, Size size, int set, int y) {
  const std::uint8_t* bytes =
      saved + head +
      (static_cast<std::size_t>(set) * static_cast<std::size_t>(size.height) + static_cast<std::size_t>(y)) *
          row_bytes(size);
  std::uint64_t row = 0;
  for (std::size_t i = row_bytes(size); i-- > 0;) row = row << 8 | bytes[i];
  return row;
}

bool can_be_restored(const std::uint8_t* saved, std::size_t bytes, Size size) {
  if (bytes < saved_bytes(size)) return false;
  const auto expected = head_of(size);
  for (std::size_t i = 0; i < head; ++i)
    if (saved[i] != expected[i]) return false;
  if (checksum(saved, saved_bytes(size)) != 0) return false;  // so it is after its own checksum
  const Knowledge nothing(size);
  for (int side = 0; side < 2; ++side)
    for (int y = 0; y < size.height; ++y) {
      const std::uint64_t possible = saved_row(saved, size, 2 + side, y);
      if ((possible & ~row_of(nothing, 2 + side, y)) != 0 || (saved_row(saved, size, side, y) & ~possible) != 0)
        return false;
    }
  return true;
}

}  // namespace

labmouse_core_status labmouse_core_create(void* memory, std::size_t bytes, int strategy, const labmouse_core_maze* maze,
                                          labmouse_core** mouse) {
  if (mouse == nullptr) return LABMOUSE_CORE_NULL;
  *mouse = nullptr;
  if (memory == nullptr || maze == nullptr || maze->goals == nullptr) return LABMOUSE_CORE_NULL;
  const Size size{maze->width, maze->height};
  const auto number = static_cast<std::size_t>(strategy);
  if (number >= strategies.size() || !size.valid() || size.width > max_side || size.height > max_side ||
      !size.contains({maze->x, maze->y}) || maze->heading > 3 || maze->goal_count < 1 || maze->longest < 1 ||
      maze->longest > Motion::max_longest || maze->sight < 1 || maze->sight > max_side || maze->budget < 1)
    return LABMOUSE_CORE_RANGE;
  Briefing briefing{.size = size,
                    .start = {{maze->x, maze->y}, all_headings[maze->heading]},
                    .goals = {},
                    .motion = strides(maze->longest),
                    .budget = maze->budget,
                    .sight = maze->sight};
  for (int i = 0; i < maze->goal_count; ++i) {
    const Cell goal{maze->goals[i][0], maze->goals[i][1]};
    if (!size.contains(goal)) return LABMOUSE_CORE_RANGE;
    briefing.goals.insert(goal);
  }
  const std::size_t side = maze->width > maze->height ? maze->width : maze->height;
  if (bytes < LABMOUSE_CORE_MEMORY(side, strategy)) return LABMOUSE_CORE_MEMORY_SHORT;
  *mouse = make_in(memory, bytes, *strategies[number], briefing);
  return LABMOUSE_CORE_OK;
}

labmouse_core_status labmouse_core_reset(labmouse_core* mouse) {
  if (mouse == nullptr) return LABMOUSE_CORE_NULL;
  if (!is_mouse(mouse)) return LABMOUSE_CORE_ORDER;
  const Briefing briefing = mouse->briefing;
  make_in(mouse->memory, mouse->bytes, *mouse->entry, briefing);
  return LABMOUSE_CORE_OK;
}

labmouse_core_status labmouse_core_observe(labmouse_core* mouse, std::uint8_t left, std::uint8_t ahead,
                                           std::uint8_t right) {
  if (mouse == nullptr) return LABMOUSE_CORE_NULL;
  if (!is_mouse(mouse) || mouse->next > Next::reading) return LABMOUSE_CORE_ORDER;
  const int sight = mouse->briefing.sight;
  if (left > sight || ahead > sight || right > sight) return LABMOUSE_CORE_RANGE;
  mouse->seen = {left, ahead, right};
  mouse->next = Next::decision;
  return LABMOUSE_CORE_OK;
}

labmouse_core_status labmouse_core_decide(labmouse_core* mouse, labmouse_core_action* action) {
  if (mouse == nullptr || action == nullptr) return LABMOUSE_CORE_NULL;
  if (!is_mouse(mouse) || mouse->next != Next::decision) return LABMOUSE_CORE_ORDER;
  *action = {LABMOUSE_CORE_END, 0, 0};
  mouse->next = Next::nothing;
  if (mouse->arrived) return LABMOUSE_CORE_OK;
  Action chosen;
  if (!mouse->is_restored) {
    chosen = mouse->strategy->decide(mouse->seen);
  } else if (!mouse->restored.learn(mouse->pose, mouse->seen)) {
    chosen = Action::forfeit(ForfeitReason::contradiction);
  } else {
    mouse->to_goal.fill(mouse->restored.open(), mouse->briefing.goals);
    chosen = step_along(mouse->to_goal, mouse->restored.open(), mouse->pose);
  }
  if (chosen.kind == Action::Kind::forfeit) return status_of(chosen.reason);
  mouse->next = Next::reading;
  if (chosen.kind == Action::Kind::reset) {
    action->kind = LABMOUSE_CORE_RESET;
    mouse->racing = true;
    mouse->pose = mouse->briefing.start;
    return LABMOUSE_CORE_OK;
  }
  *action = {LABMOUSE_CORE_STEP, static_cast<std::int8_t>(chosen.rotation / 90),
             static_cast<std::int8_t>(chosen.movement)};
  mouse->pose = after(mouse->pose, chosen);
  mouse->arrived = mouse->racing && mouse->briefing.goals.contains(mouse->pose.cell);
  return LABMOUSE_CORE_OK;
}

labmouse_core_status labmouse_core_save(const labmouse_core* mouse, std::uint8_t* saved, std::size_t bytes,
                                        std::size_t* used) {
  if (mouse == nullptr || saved == nullptr || used == nullptr) return LABMOUSE_CORE_NULL;
  if (!is_mouse(mouse)) return LABMOUSE_CORE_ORDER;
  const Size size = mouse->briefing.size;
  if (bytes < saved_bytes(size)) return LABMOUSE_CORE_MEMORY_SHORT;
  std::uint8_t* next = saved;
  for (const std::uint8_t byte : head_of(size)) *next++ = byte;
  for (int set = 0; set < 4; ++set)
    for (int y = 0; y < size.height; ++y)
      for (std::size_t i = 0; i < row_bytes(size); ++i)
        *next++ = static_cast<std::uint8_t>(row_of(mouse->map(), set, y) >> 8 * i);
  const std::uint16_t sum = checksum(saved, static_cast<std::size_t>(next - saved));
  *next++ = static_cast<std::uint8_t>(sum >> 8);
  *next++ = static_cast<std::uint8_t>(sum);
  *used = static_cast<std::size_t>(next - saved);
  return LABMOUSE_CORE_OK;
}

labmouse_core_status labmouse_core_restore(labmouse_core* mouse, const std::uint8_t* saved, std::size_t bytes) {
  if (mouse == nullptr || saved == nullptr) return LABMOUSE_CORE_NULL;
  if (!is_mouse(mouse) || mouse->next != Next::first_reading) return LABMOUSE_CORE_ORDER;
  const Size size = mouse->briefing.size;
  if (!can_be_restored(saved, bytes, size)) return LABMOUSE_CORE_BAD_MAP;
  mouse->restored = Knowledge(size, mouse->briefing.sight);
  for (int side = 0; side < 2; ++side)
    for (int y = 0; y < size.height; ++y) {
      const std::uint64_t open = saved_row(saved, size, side, y), possible = saved_row(saved, size, 2 + side, y);
      const std::uint64_t all = row_of(mouse->restored, 2 + side, y);
      for (int x = 0; x < size.width; ++x)
        if ((((all & ~possible) | open) >> x & 1U) != 0)
          mouse->restored.learn({{x, y}, side == 0 ? Heading::north : Heading::east}, (open >> x & 1U) != 0);
    }
  mouse->is_restored = mouse->racing = true;
  return LABMOUSE_CORE_OK;
}
