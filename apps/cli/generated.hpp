// Options for generated mazes.
#pragma once

#include <string>

#include "labmouse/maze/generators/generator.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// Reads a size such as 16x16; throws UsageError if it is none.
Size read_size(const std::string& text);

/// A generator and the mazes that it is to make.
struct GeneratedMazes {
  std::string kind = "contest", size = "16x16";
  double loops = 0.0;

  /// Adds --size and --loops.
  void add_to(Command& command);
  /// Throws UsageError where there is no such generator.
  const Generator& generator() const;
  /// Throws UsageError where the generator refuses it.
  GeneratorOrder order(std::uint64_t seed) const;
};

}  // namespace labmouse::cli
