// Any bytes as a lineup: there are mice with names of their own and limits within their ranges, or there are problems.
#include <set>

#include "labmouse/lab/lineups/lineup_file.hpp"
#include "tests/fuzz/check_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using labmouse::fuzz::require;
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const labmouse::LineupResult read = labmouse::read_lineup(text);
  require(read.mice.empty() != read.problems.empty());
  require(read.problems.size() <= labmouse::most_problems);
  std::set<std::string> names;
  for (const labmouse::LineupMouse& mouse : read.mice) {
    require(!mouse.name.empty() && names.insert(mouse.name).second);
    require(!mouse.what.empty() && mouse.line > 0);
    const labmouse::GuestLimits limits = mouse.limits_over({});
    require(limits.start.count() > 0 && limits.processes > 0 && limits.memory > 0);
  }
  return 0;
}
