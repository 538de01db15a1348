#include "labmouse/lab/system/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <optional>

namespace labmouse {

void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  // Allow `jobs` threads even where there are fewer processors.
  std::optional<tbb::global_control> threads;
  if (jobs > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs > 0 ? jobs : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, work, tbb::simple_partitioner()); });
}

}  // namespace labmouse
