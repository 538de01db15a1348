// Any bytes as a record: there is a record or a problem, and what is one can be played without a crash.
#include <cstdlib>

#include "labmouse/lab/record_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto result = labmouse::read_record({reinterpret_cast<const char*>(bytes), size});
  if (result.file.has_value() != result.problems.empty()) std::abort();
  if (result.file) labmouse::replay(*result.file, *result.file->maze);
  return 0;
}
