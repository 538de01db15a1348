#include "explain.hpp"

#include "command.hpp"
#include "labmouse/lab/records/explanation.hpp"

namespace labmouse::cli {

void add_explain(Command& command, ExplainOptions& options) {
  Option* flag = command.add_flag(
      "--explain", options.wanted,
      "Show which walls the mouse chose from, and why it stopped; of a record in seconds, what happened");
  command.add_option("--candidates", options.candidates, "Number of candidates that --explain shows for each choice")
      ->needs(flag)
      ->check(in_range(1, 10'000))
      ->capture_default_str();
}

void explain(const RecordFile& file, const ExplainOptions& options, const std::string& none) {
  if (!options.wanted) return;
  const std::string text = explanation_of(file, options.candidates);
  print("\n" + (text.empty() ? none + "\n" : text));
}

}  // namespace labmouse::cli
