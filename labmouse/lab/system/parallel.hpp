// Work on as many threads as were asked for.
#pragma once

#include <cstddef>
#include <functional>

namespace labmouse {

/// Calls work(i) for each i below `count`, in no order that means anything, on `jobs` threads; 0 takes as many as there
/// are processors. Returns when all are done.
void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace labmouse
