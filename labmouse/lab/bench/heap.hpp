// The heap of this process.
#pragma once

#include <cstddef>

namespace labmouse {

/// Bytes that are in use of it; 0 where the C library does not tell.
std::size_t heap_in_use();

}  // namespace labmouse
