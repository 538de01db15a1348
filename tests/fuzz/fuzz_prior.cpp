// Any bytes as a prior: there is a prior or there are problems, and a prior survives being written.
#include "labmouse/lab/mice/prior_file.hpp"
#include "tests/fuzz/check_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using labmouse::fuzz::require;
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const labmouse::ReadPriorResult read = labmouse::read_prior(text);
  require(read.prior.has_value() == read.problems.empty());
  require(read.problems.size() <= labmouse::most_problems);
  if (!read.prior) return 0;
  // Its bytes as the version, too: whatever that is, it stays in its comment.
  const std::string written = labmouse::write_prior(*read.prior, {std::string(text), {}, {}});
  require(labmouse::read_prior(written).prior == read.prior);
  return 0;
}
