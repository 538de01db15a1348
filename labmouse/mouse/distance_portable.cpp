// The kernels for every processor: vectors of 16 bytes are SSE2, NEON or WebAssembly's SIMD128, or plain words.
#define LABMOUSE_KERNEL portable
#define LABMOUSE_CHUNK 16
#include "labmouse/mouse/distance_searches.hpp"
