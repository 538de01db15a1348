/* The functions of firmware/labmouse_tiny.h, compiled as C99 and as C++11. */
#ifndef TINY_IN_C_H
#define TINY_IN_C_H
#include "labmouse_tiny.h"
#ifdef __cplusplus
extern "C" {
#endif
struct tiny_functions {
  enum labmouse_tiny_status (*create)(struct labmouse_tiny *, uint8_t);
  enum labmouse_tiny_status (*start)(struct labmouse_tiny *, uint8_t);
  enum labmouse_tiny_status (*set_goals)(struct labmouse_tiny *, const uint8_t (*)[2], uint8_t);
  enum labmouse_tiny_status (*observe)(struct labmouse_tiny *, uint8_t, uint8_t, uint8_t);
  enum labmouse_tiny_status (*decide)(struct labmouse_tiny *, enum labmouse_tiny_move *);
  enum labmouse_tiny_status (*turned)(struct labmouse_tiny *, uint8_t);
  enum labmouse_tiny_status (*print)(const struct labmouse_tiny *, int (*)(int));
  enum labmouse_tiny_status (*save)(const struct labmouse_tiny *, void (*)(uint16_t, uint8_t));
  enum labmouse_tiny_status (*restore)(struct labmouse_tiny *, uint8_t (*)(uint16_t));
};
extern const struct tiny_functions tiny_in_c, tiny_in_cpp11;
#ifdef __cplusplus
}
#endif
#endif
