// Errors of the user, which become exceptions in Python.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"

namespace labmouse::python {

/// Becomes labmouse.Error. The text is the message of the command line; a leading "error: " is removed.
struct UserError : std::runtime_error {
  explicit UserError(const std::string& line);
};

/// One error with a line for each problem of these files.
UserError error_of(const std::vector<SkippedFile>& files);

}  // namespace labmouse::python
