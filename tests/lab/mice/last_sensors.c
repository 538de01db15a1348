/* A controller whose duties are what the last infrared sensor and the last ToF sensor read. */
#include <stddef.h>

#include "labmouse_controller.h"

static const struct labmouse_briefing *briefing;

static void *begin(const struct labmouse_briefing *told) {
  briefing = told;
  return NULL;
}

static struct labmouse_drive tick(void *memory, const struct labmouse_sense *sense) {
  const struct labmouse_robot *robot = &briefing->robot;
  struct labmouse_drive said = {0, 0, LABMOUSE_DRIVE};
  (void)memory;
  said.left = sense->infrared[robot->infrared_sensors - 1];
  said.right = sense->ranges[robot->range_sensors - 1];
  return said;
}

static void carried(void *memory, int crashed) {
  (void)memory;
  (void)crashed;
}
static void end(void *memory) { (void)memory; }

const struct labmouse_controller labmouse_controller = {begin, tick, carried, end, 1};
