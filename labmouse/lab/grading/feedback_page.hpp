// The page for one student: what was lost where, with the replays inside.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/grading/grades.hpp"

namespace labmouse {

/// The page with the points of one student ahead of everything else, and with the results and records of the contests
/// of that student as a report. Hidden mazes are in it only where the task file shows them.
/// @param page must pass wrong_page().
std::string feedback_page(const GradingPlan& plan, const Grades& grades, const StudentContests& contests,
                          const StudentGrade& student, std::string_view page);

}  // namespace labmouse
