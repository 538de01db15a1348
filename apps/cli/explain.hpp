// --explain: why the mouse went where it went.
#pragma once

#include <string>

#include "options.hpp"

namespace labmouse::cli {

struct ExplainOptions {
  bool wanted = false;
  int candidates = 5;  ///< shown of each choice
};
/// Adds --explain and --candidates.
void add_explain(Command& command, ExplainOptions& options);

}  // namespace labmouse::cli
