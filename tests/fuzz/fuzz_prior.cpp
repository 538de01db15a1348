// Any bytes as a prior: there is a prior or there are problems, and a prior survives being written.
#include "labmouse/lab/mice/prior_file.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(prior) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const ReadPriorResult read = read_prior(text);
  require(read.prior.has_value() == read.problems.empty());
  require(read.problems.size() <= most_problems);
  if (!read.prior) return 0;
  // Its bytes as the version, too: whatever that is, it stays in its comment.
  const std::string written = write_prior(*read.prior, {std::string(text), {}, {}});
  require(read_prior(written).prior == read.prior);
  return 0;
}

}  // namespace labmouse::fuzz
