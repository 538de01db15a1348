// What a user did wrong, as an exception in Python.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"

namespace labmouse::python {

/// Becomes labmouse.Error: what the command line would say, without the word "error: " before a sentence of its own.
struct UserError : std::runtime_error {
  explicit UserError(const std::string& line);
};

/// All that is wrong with some files, a line each.
UserError error_of(const std::vector<SkippedFile>& files);

}  // namespace labmouse::python
