/* The strategies of labmouse on a chip: flood, flood-return, certify and ariadne in steps. This interface is C99. What is
 * behind it is C++20 (GCC 12 or later, -fno-exceptions -fno-rtti): firmware/labmouse_core.cpp with labmouse's modules
 * functions, hardware, grid, chance, mouse and strategies.
 *
 *   static unsigned char memory[LABMOUSE_CORE_MEMORY(16, LABMOUSE_CORE_ARIADNE)];
 *   struct labmouse_core *mouse;
 *   struct labmouse_core_maze maze = {16, 16, 0, 0, 0, goals, 4, 3, 63, 1000};
 *   struct labmouse_core_action action;
 *   labmouse_core_create(memory, sizeof memory, LABMOUSE_CORE_ARIADNE, &maze, &mouse);
 *   do {
 *     labmouse_core_observe(mouse, left, ahead, right);
 *     if (labmouse_core_decide(mouse, &action) != LABMOUSE_CORE_OK) stop();
 *     perform(&action);
 *   } while (action.kind != LABMOUSE_CORE_END);
 *
 * Each function returns a status. None waits, prints, throws, or takes memory other than the caller's. Nothing changes where
 * a status is NULL, ORDER, RANGE, MEMORY or BAD_MAP. Only one mouse may be created or reset at a time: these two replace the
 * program's operator new while they run.
 */
#ifndef LABMOUSE_CORE_H
#define LABMOUSE_CORE_H
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

#define LABMOUSE_CORE_VERSION 1 /* of the saved map */

enum labmouse_core_strategy {
  LABMOUSE_CORE_FLOOD,
  LABMOUSE_CORE_FLOOD_RETURN,
  LABMOUSE_CORE_CERTIFY,
  LABMOUSE_CORE_ARIADNE
};

/* Bytes that a mouse needs, for mazes whose longer side has so many cells: a constant where both arguments are. */
#define LABMOUSE_CORE_BY_SIDE(side, to_16, to_32, to_64) ((side) <= 16 ? (to_16) : (side) <= 32 ? (to_32) : (to_64))
#define LABMOUSE_CORE_MEMORY(side, strategy)                                                        \
  ((strategy) < LABMOUSE_CORE_CERTIFY    ? LABMOUSE_CORE_BY_SIDE(side, 8192u, 12800u, 31744u)       \
   : (strategy) == LABMOUSE_CORE_CERTIFY ? LABMOUSE_CORE_BY_SIDE(side, 14336u, 27648u, 83968u)      \
                                         : LABMOUSE_CORE_BY_SIDE(side, 30720u, 50176u, 131072u))

/* Bytes of the saved map of such a maze. */
#define LABMOUSE_CORE_SAVED(side) (7 + 4 * (side) * (((side) + 7) / 8))

enum labmouse_core_status {
  LABMOUSE_CORE_OK,
  LABMOUSE_CORE_NULL,          /* a pointer is null */
  LABMOUSE_CORE_ORDER,         /* the function is not allowed now */
  LABMOUSE_CORE_RANGE,         /* an argument is out of range */
  LABMOUSE_CORE_MEMORY_SHORT,  /* the memory is too small */
  LABMOUSE_CORE_CONTRADICTION, /* a reading contradicts the map: the run is over */
  LABMOUSE_CORE_NO_ROUTE,      /* the map has no route to where the mouse is to go: the run is over */
  LABMOUSE_CORE_BAD_MAP        /* the saved map is of another version or maze, or corrupted */
};

/* What the mouse knows before it starts. Cells count from (0,0) in the south-west corner. */
struct labmouse_core_maze {
  uint8_t width, height;    /* cells, 1 to 64 */
  uint8_t x, y;             /* the start */
  uint8_t heading;          /* at the start: 0 north, 1 east, 2 south, 3 west */
  const uint8_t (*goals)[2]; /* x and y of each cell of the goal */
  uint8_t goal_count;       /* 1 to 255 */
  uint8_t longest;          /* the longest move of one step, in cells: 1 to 8 */
  uint8_t sight;            /* range of a reading in cells, 1 to 64; 1 where sensors see the walls of one cell */
  uint16_t budget;          /* steps of a contest, at least 1 */
};

enum labmouse_core_kind {
  LABMOUSE_CORE_STEP,  /* turn, then move straight */
  LABMOUSE_CORE_RESET, /* the search run has ended: go to the start, for the speed run */
  LABMOUSE_CORE_END    /* the speed run has ended in the goal */
};
struct labmouse_core_action {
  enum labmouse_core_kind kind;
  int8_t quarters; /* quarter turns to the right before the move: -1, 0 or 1 */
  int8_t cells;    /* of the move, negative backwards */
};

struct labmouse_core;

/* Creates a mouse in the memory, which must not move while the mouse is used. To be called first.
 * bytes: of the memory, at least LABMOUSE_CORE_MEMORY(longer side, strategy).
 * strategy: one of enum labmouse_core_strategy.
 * mouse: is set to the mouse, or to null. */
enum labmouse_core_status labmouse_core_create(void *memory, size_t bytes, int strategy,
                                               const struct labmouse_core_maze *maze, struct labmouse_core **mouse);
/* Forgets the map and puts the mouse at the start of a search run. */
enum labmouse_core_status labmouse_core_reset(struct labmouse_core *mouse);
/* Takes a reading: the open cells to the left, ahead and to the right, up to the sight. Allowed at the start and after each
 * step and reset. */
enum labmouse_core_status labmouse_core_observe(struct labmouse_core *mouse, uint8_t left, uint8_t ahead,
                                                uint8_t right);
/* Decides on the next action, which is taken to have been performed when the next reading comes. Allowed after
 * labmouse_core_observe. */
enum labmouse_core_status labmouse_core_decide(struct labmouse_core *mouse, struct labmouse_core_action *action);
/* Saves the map.
 * bytes: of `saved`, at least LABMOUSE_CORE_SAVED(longer side).
 * used: is set to the number of bytes that were written. */
enum labmouse_core_status labmouse_core_save(const struct labmouse_core *mouse, uint8_t *saved, size_t bytes,
                                             size_t *used);
/* Restores a map of the same size, and begins a speed run on it at the start. Allowed before the first reading. */
enum labmouse_core_status labmouse_core_restore(struct labmouse_core *mouse, const uint8_t *saved, size_t bytes);

#ifdef __cplusplus
}
#endif
#endif
