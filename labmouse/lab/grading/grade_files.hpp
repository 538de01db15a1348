// Grades as files that other programs read: JUnit XML, and results for Gradescope.
#pragma once

#include <string>

#include "labmouse/lab/grading/grades.hpp"

namespace labmouse {

/// A test suite for each student, with a test for each task, which fails where points are lost.
std::string junit_of(const Grades& grades);

/// The `results.json` of an autograder of Gradescope for one student.
std::string gradescope_of(const Grades& grades, const StudentGrade& student);

}  // namespace labmouse
