// The kernels for processors with AVX2; compiled with -mavx2, and empty where the build does not ask for it.
#if defined(__AVX2__)
#define LABMOUSE_KERNEL wide
#define LABMOUSE_CHUNK 32
#include "labmouse/mouse/distance_searches.hpp"
#endif
