// Heap use of this process.
#pragma once

#include <cstddef>

namespace labmouse {

/// Bytes of the heap in use; 0 if the C library is not glibc.
std::size_t heap_in_use();

}  // namespace labmouse
