// Priors as files, described in docs/research/priors.md: comments and numbers with commas, which the compiler can
// include, too.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/grid/cell.hpp"
#include "labmouse/lab/mice/prior_learning.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse {

/// Where a prior comes from: what its file says of it, for people.
struct PriorProvenance {
  std::string version;      ///< of the program that learned it
  std::vector<Size> mazes;  ///< the size of each maze, in any order
  PriorFit fit;
};

/// The same prior with the same provenance gives the same bytes.
std::string write_prior(const WallPrior& prior, const PriorProvenance& provenance);

/// A prior, or what is wrong with the text: exactly one of the two is there.
struct ReadPriorResult {
  std::optional<WallPrior> prior;
  std::vector<Problem> problems;
};

/// Reads a prior; what its comments say is not looked at, but the first one, which names the format. At most 1 MiB.
ReadPriorResult read_prior(std::string_view text);

}  // namespace labmouse
