// Heap use of this process.
#pragma once

#include <cstddef>

namespace labmouse {

/// Bytes of the heap in use; 0 where the C library has no such figure (other than glibc).
std::size_t heap_in_use();

}  // namespace labmouse
