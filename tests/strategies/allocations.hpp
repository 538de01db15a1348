// Counts what this program takes from the heap: the test program replaces operator new.
#pragma once

namespace labmouse::test {

/// Allocations since the program began.
long allocations();

}  // namespace labmouse::test
