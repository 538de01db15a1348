// Grades: how many points each student has in each task, and why not more.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/grading/class_contests.hpp"

namespace labmouse {

/// A contest as a task judges it.
struct GradedContest {
  std::string maze;
  int run = 0;  ///< from 0
  std::string outcome;
  std::optional<double> score;  ///< in the unit of the world
  std::optional<double> best;   ///< the best possible one
  std::string lost;             ///< why it does not fulfil the task on its own; empty where it does
  /// Why the program failed: the message of labmouse, then the last lines of its standard error. Empty in hidden
  /// mazes, because a program can print the maze, and if the output of the student has the same lines.
  std::vector<std::string> output;
  bool hidden = false;  ///< whether the student must not see the maze, nor what was scored in it
};

struct TaskGrade {
  double points = 0.0;
  std::string lost;                     ///< why there are not more points, in one line; empty where there are all
  std::vector<GradedContest> contests;  ///< in the order of the task's mazes; none of a broken program
};

struct StudentGrade {
  std::string name;
  double points = 0.0;
  std::string broken;  ///< why the program could not be run, or did not start in any contest; empty where it did
  std::vector<std::string> output;  ///< the last lines of the standard error of a program that did not start
  std::vector<TaskGrade> tasks;
};

struct GradedTask {
  std::string name;
  double points = 0.0;
};

struct Grades {
  std::vector<GradedTask> tasks;
  double points = 0.0;                 ///< of all tasks together
  std::string unit;                    ///< of scores
  std::vector<StudentGrade> students;  ///< in the order of the class
  std::string notes;                   ///< what scores are, and what programs could do to the machine, in lines
  int not_judged = 0;                  ///< contests that count as lost because the machine was too busy: grade again
};

/// The grades of a class whose contests are all done.
Grades grades_of(const GradingPlan& plan, const ClassContests& contests);

/// The grade as students may see it: of hidden mazes only how contests ended and whether they fulfil the task. Scores
/// in them would tell something of these mazes to whoever may hand in again.
TaskGrade for_student(TaskGrade grade);

/// Points as they are shown: "8.5".
std::string points_text(double points);

}  // namespace labmouse
