// Any bytes as a record in seconds: there is a record or a problem, and what is one can be played again and written.
#include <cstdlib>

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/system/version.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(drive_record) {
  const auto result = read_drive_record({reinterpret_cast<const char*>(bytes), size});
  if (result.file.has_value() != result.problems.empty()) std::abort();
  if (!result.file || !replay(*result.file).empty() || !result.file->ended) return 0;
  const auto again = read_drive_record(write_drive_record(*result.file));
  if (!again.file || again.file->record != result.file->record) std::abort();
  return 0;
}

}  // namespace labmouse::fuzz
