/* firmware/labmouse_core.h as C99 sees it. */
#ifndef CORE_IN_C_H
#define CORE_IN_C_H
#include "labmouse_core.h"
#ifdef __cplusplus
extern "C" {
#endif
/* What mazes of 16 and 32 cells on a side need, by strategy, as constants of the compiler. */
extern const size_t core_in_c_bytes[4][2];
/* The cells of a first step along an open wall; negative if something fails. */
int core_in_c_first_step(void);
#ifdef __cplusplus
}
#endif
#endif
