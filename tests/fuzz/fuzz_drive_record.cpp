// Any bytes as a record in seconds: there is a record or a problem, and what is one can be played again and written.
#include <cstdlib>

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/system/version.hpp"

// A record names the version that wrote it; that of a fuzzer is none.
std::string_view labmouse::version() { return "fuzzer"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto result = labmouse::read_drive_record({reinterpret_cast<const char*>(bytes), size});
  if (result.file.has_value() != result.problems.empty()) std::abort();
  if (!result.file || !labmouse::replay(*result.file).empty() || !result.file->ended) return 0;
  const auto again = labmouse::read_drive_record(labmouse::write_drive_record(*result.file));
  if (!again.file || again.file->record != result.file->record) std::abort();
  return 0;
}
