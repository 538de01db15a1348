// Counts what this program takes from the heap: the test program replaces operator new.
#pragma once

namespace labmouse::test {

/// Allocations since the program began.
long allocations();
/// Bytes that they asked for, also those that have been given back.
long allocated_bytes();

}  // namespace labmouse::test
