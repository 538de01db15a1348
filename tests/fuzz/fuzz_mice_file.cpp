// Any bytes as a lineup: there are mice with names of their own and limits within their ranges, or there are problems.
#include <set>

#include "labmouse/lab/mice_files/mice_file.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(mice_file) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const MiceFileResult read = read_mice_file(text);
  require(read.mice.empty() != read.problems.empty());
  require(read.problems.size() <= most_problems);
  std::set<std::string> names;
  for (const MiceFileEntry& mouse : read.mice) {
    require(!mouse.name.empty() && names.insert(mouse.name).second);
    require(!mouse.what.empty() && mouse.line > 0);
    const ExternalLimits limits = mouse.limits.over({});
    require(limits.start.count() > 0 && limits.processes > 0 && limits.memory > 0);
  }
  return 0;
}

}  // namespace labmouse::fuzz
