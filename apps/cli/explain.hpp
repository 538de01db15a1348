// --explain: why the mouse went where it went.
#pragma once

#include <string>

#include "labmouse/lab/records/record_file.hpp"
#include "options.hpp"

namespace labmouse::cli {

struct ExplainOptions {
  bool wanted = false;
  int candidates = 5;  ///< shown of each choice
};
/// Adds --explain and --candidates.
void add_explain(Command& command, ExplainOptions& options);

/// Prints the reasons of the record where they are wanted; where it has none, the line `none` in their place.
void explain(const RecordFile& file, const ExplainOptions& options, const std::string& none);

}  // namespace labmouse::cli
