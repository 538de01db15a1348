// The students of a class, by their mice file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// A student and the program that was handed in.
struct Student {
  std::string name;
  std::optional<Contestant> mouse;  ///< nothing where the program cannot be run
  std::string broken;               ///< the reason; empty where there is a mouse
};

/// Either students in the order of their file, or the problems of the file.
struct ClassResult {
  std::vector<Student> students;
  std::vector<Problem> problems;
};

/// Reads a mice file as a class. A mouse that cannot be read, such as one whose file is missing, is a student whose
/// program is broken, not a problem of the class.
/// @param path of the mice file, against which its paths are resolved.
/// @param text of the mice file.
/// @param options how the programs are started.
ClassResult read_class(const std::string& path, std::string_view text, const ExternalOptions& options);

}  // namespace labmouse
