#include "core_in_c.h"

#define BYTES(strategy) {LABMOUSE_CORE_MEMORY(16, strategy), LABMOUSE_CORE_MEMORY(32, strategy)}

const size_t core_in_c_bytes[4][2] = {BYTES(LABMOUSE_CORE_FLOOD), BYTES(LABMOUSE_CORE_FLOOD_RETURN),
                                      BYTES(LABMOUSE_CORE_CERTIFY), BYTES(LABMOUSE_CORE_ARIADNE)};

int core_in_c_first_step(void) {
  static union {
    double aligned;
    unsigned char bytes[LABMOUSE_CORE_MEMORY(16, LABMOUSE_CORE_FLOOD)];
  } memory;
  static const uint8_t goals[4][2] = {{7, 7}, {7, 8}, {8, 7}, {8, 8}};
  const struct labmouse_core_maze maze = {16, 16, 0, 0, 0, goals, 4, 3, 1, 1000};
  struct labmouse_core *mouse;
  struct labmouse_core_action action;
  if (labmouse_core_create(memory.bytes, sizeof memory.bytes, LABMOUSE_CORE_FLOOD, &maze, &mouse)) return -1;
  if (labmouse_core_observe(mouse, 0, 1, 0)) return -2;
  if (labmouse_core_decide(mouse, &action)) return -3;
  return action.cells;
}
