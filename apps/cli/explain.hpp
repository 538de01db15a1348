// The option --explain: the reasons of a mouse's choices.
#pragma once

#include <string>

#include "options.hpp"

namespace labmouse::cli {

/// The options --explain and --candidates.
struct ExplainOptions {
  bool wanted = false;
  int candidates = 5;  ///< number of candidates shown for each choice
};
/// Adds --explain and --candidates.
void add_explain(Command& command, ExplainOptions& options);

}  // namespace labmouse::cli
