#include "tiny_in_c.h"

#ifdef __cplusplus
#define TINY tiny_in_cpp11
#else
#define TINY tiny_in_c
#endif

const struct tiny_functions TINY = {labmouse_tiny_create,  labmouse_tiny_start,  labmouse_tiny_set_goals,
                                    labmouse_tiny_observe, labmouse_tiny_decide, labmouse_tiny_turned,
                                    labmouse_tiny_print,   labmouse_tiny_save,   labmouse_tiny_restore};
