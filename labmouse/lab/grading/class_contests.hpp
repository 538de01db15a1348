// The contests of a class: each student's program in each maze of the tasks.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/grading/grading_plan.hpp"
#include "labmouse/lab/grading/students.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The contests of one student.
struct StudentContests {
  std::string name;
  std::string broken;  ///< why the program was not run at all; empty where there is a race
  /// The race of this student alone. Its mazes are those of the plan, in the same order. Contests that were not run
  /// because the program hung before are not done.
  std::optional<Race> race;
  /// For each contest of the race, in the same order.
  std::vector<std::optional<int>> known_wall_hits;
  std::vector<std::string> records;  ///< texts of those that were to be kept; others are empty
  std::string hung_in;               ///< the name of the maze in which the program hung before it was given up
};

struct ClassContests {
  std::vector<StudentContests> students;  ///< in the order of the class
  std::vector<Contestant> mice;           ///< all that ran
  bool stopped = false;                   ///< before all contests were done; then students have no races
};

struct ClassOrder {
  int jobs = 0;               ///< threads; 0 takes as many as there are processors. Results do not depend on it.
  bool keep_records = false;  ///< of the first contest in each maze that students may see
  std::vector<std::string> files = {};  ///< to hide from programs, besides those of the plan
  /// Asked before each contest and each decision; once it is true no other begins. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Called after each contest with how many there are at most.
  std::function<void(std::size_t)> advanced = {};
};

/// Runs all contests. A program that in the first maze does not start or answer within its time limits is not run in
/// the others, because each of them would cost these limits again.
ClassContests run_class(const GradingPlan& plan, const std::vector<Student>& students, const ClassOrder& order);

}  // namespace labmouse
