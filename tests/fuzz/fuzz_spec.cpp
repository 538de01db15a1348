// Any bytes as a SPEC: there are mice or an error, and mice have SPECs that read as the same mice again.
#include <cstdlib>

#include "labmouse/lab/mice/specs.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(spec) {
  // A named Python, so that none is started to ask for its version.
  ExternalOptions options;
  options.python = "/bin/sh";
  const auto result = read_specs({reinterpret_cast<const char*>(bytes), size}, options);
  if (result.contestants.empty() == result.error.empty()) std::abort();
  for (const auto& mouse : result.contestants) {
    const std::string& spec = spec_of(mouse);
    const auto again = read_specs(spec, options);
    if (again.contestants.size() != 1 || again.contestants.front().name != spec) std::abort();
    const auto& kind = again.contestants.front().kind;
    if (kind.index() != mouse.kind.index()) std::abort();
    const auto* program = std::get_if<MmsProgram>(&kind);
    if (program != nullptr && program->launch.words != std::get<MmsProgram>(mouse.kind).launch.words) std::abort();
  }
  return 0;
}

}  // namespace labmouse::fuzz
