#include "stream_in_c.c"
