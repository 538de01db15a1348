/* The smallest program with every function and strategy of firmware/labmouse_core.h. */
#include "labmouse_core.h"

static unsigned char memory[LABMOUSE_CORE_MEMORY(16, LABMOUSE_CORE_ARIADNE)];
static uint8_t saved[LABMOUSE_CORE_SAVED(16)];
static volatile int port;

int main(void) {
  static const uint8_t goals[4][2] = {{7, 7}, {7, 8}, {8, 7}, {8, 8}};
  const struct labmouse_core_maze maze = {16, 16, 0, 0, 0, goals, 4, 3, 1, 1000};
  struct labmouse_core *mouse;
  struct labmouse_core_action action;
  size_t used;
  port = labmouse_core_create(memory, sizeof memory, port, &maze, &mouse);
  port = labmouse_core_reset(mouse);
  port = labmouse_core_restore(mouse, saved, sizeof saved);
  port = labmouse_core_observe(mouse, (uint8_t)port, (uint8_t)port, (uint8_t)port);
  port = labmouse_core_decide(mouse, &action);
  port = labmouse_core_save(mouse, saved, sizeof saved, &used);
  return 0;
}
