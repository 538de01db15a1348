#include "tiny_in_c.c"
