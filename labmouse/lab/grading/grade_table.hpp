// Grades as a table for a terminal, as CSV and as JSON.
#pragma once

#include <string>

#include "labmouse/lab/grading/grades.hpp"

namespace labmouse {

/// The tasks, a line for each student, and why points were lost.
std::string table_of(const Grades& grades);

/// A line for each student: the name, the points in each task, and the sum.
std::string csv_of(const Grades& grades);

/// All of the grades, with each contest.
std::string json_of(const Grades& grades);

}  // namespace labmouse
