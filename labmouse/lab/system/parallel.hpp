// A loop on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace labmouse {

/// Calls work(i) for each i below `count`, in any order, on `jobs` threads (0: one for each processor). Returns when
/// all calls have ended.
void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace labmouse
