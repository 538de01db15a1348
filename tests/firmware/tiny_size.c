/* The smallest program with every function of firmware/labmouse_tiny.h: its size is what a builder pays at most. */
#include "labmouse_tiny.h"

static struct labmouse_tiny mouse;
static volatile uint8_t port;

static int put(int letter) {
  port = (uint8_t)letter;
  return letter;
}
static void write_byte(uint16_t address, uint8_t byte) { port = (uint8_t)(address + byte); }
static uint8_t read_byte(uint16_t address) { return (uint8_t)(port + address); }

int main(void) {
  static const uint8_t goal[1][2] = {{1, 1}};
  enum labmouse_tiny_move move = LABMOUSE_TINY_END;
  port = labmouse_tiny_create(&mouse, port);
  port = labmouse_tiny_set_goals(&mouse, goal, port);
  port = labmouse_tiny_start(&mouse, port);
  port = labmouse_tiny_observe(&mouse, port, port, port);
  port = labmouse_tiny_decide(&mouse, &move);
  port = (uint8_t)move;
  port = labmouse_tiny_turned(&mouse, port);
  port = labmouse_tiny_print(&mouse, put);
  port = labmouse_tiny_save(&mouse, write_byte);
  port = labmouse_tiny_restore(&mouse, read_byte);
  return 0;
}
