// Files of priors, described in docs/research/priors.md: comments and comma-separated numbers, which C++ can #include,
// too.
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

/// The origin of a prior, as comments in its file.
struct PriorProvenance {
  std::string version;      ///< of the program that learned it
  std::vector<Size> mazes;  ///< the size of each maze, in any order
  PriorFit fit;
};

/// The text of a prior file. Equal arguments give equal bytes.
std::string write_prior(const WallPrior& prior, const PriorProvenance& provenance);

/// Either a prior, or the problems of the text.
struct ReadPriorResult {
  std::optional<WallPrior> prior;
  std::vector<Problem> problems;
};

/// Reads a prior of at most 1 MiB. Comments are ignored except the first, which names the format.
ReadPriorResult read_prior(std::string_view text);

}  // namespace labmouse
