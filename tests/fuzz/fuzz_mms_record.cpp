// Any bytes as a record of mms: there is a record or a problem, and what is one can be given to the simulator again.
#include <cstdlib>

#include "labmouse/lab/records/mms_record_file.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(mms_record) {
  const auto result = read_mms_record({reinterpret_cast<const char*>(bytes), size});
  if (result.file.has_value() != result.problems.empty()) std::abort();
  if (!result.file) return 0;
  std::size_t played = 0;
  const auto count = [&](std::size_t event, const MmsHost&) {
    if (event != played++) std::abort();
  };
  const bool agrees = replay(*result.file, count).empty();
  if (agrees && played != result.file->events.size()) std::abort();
  return 0;
}

}  // namespace labmouse::fuzz
