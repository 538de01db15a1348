#include "stream_in_c.h"

#include "labmouse_stream.h"

#ifdef __cplusplus
#define STREAM stream_in_cpp11
#else
#define STREAM stream_in_c
#endif

void STREAM(void (*put)(char letter)) {
  struct labmouse_stream robot = {put, 0};
  const int32_t infrared[3] = {12, -840, 0};
  labmouse_start(&robot);
  labmouse_cell(&robot, 0, 0, 'N', 1, 0, -1);
  labmouse_number(&robot, "batt", 7900);
  labmouse_numbers(&robot, "ir", infrared, 3);
  labmouse_text(&robot, "state", "search * 2");
  labmouse_end(&robot);
  labmouse_number(&robot, "v", -2147483647 - 1);
  labmouse_end(&robot);
  labmouse_cell(&robot, 12, 63, 'W', 0, 1, 1);
  labmouse_text(&robot, "route", "NNE");
  labmouse_end(&robot);
}
