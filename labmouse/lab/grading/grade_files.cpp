#include "labmouse/lab/grading/grade_files.hpp"

#include <fmt/format.h>

#include "labmouse/lab/standings/junit_suite.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The feedback on a task, in lines.
std::string lines_of(const TaskGrade& task, const std::string& unit) {
  if (task.lost.empty()) return "";
  std::string text = fmt::format("Lost: {}\n", shown(task.lost));
  for (const GradedContest& contest : task.contests) {
    if (contest.lost.empty()) continue;
    text += fmt::format("{}: {}", shown(contest.maze), shown(contest.lost));
    if (contest.score && contest.best)
      text += fmt::format(" (score {:.3f}, best possible {:.3f} {})", *contest.score, *contest.best, unit);
    text += "\n";
    for (const std::string& line : contest.output) text += fmt::format("  | {}\n", shown(line));
  }
  return text;
}

}  // namespace

std::string junit_of(const Grades& grades) {
  std::vector<JUnitSuite> suites;
  for (const StudentGrade& student : grades.students) {
    JUnitSuite& suite = suites.emplace_back(student.name);
    for (std::size_t task = 0; task < grades.tasks.size(); ++task) {
      const TaskGrade grade = for_student(student.tasks[task]);
      if (grade.lost.empty())
        suite.pass(grades.tasks[task].name);
      else
        suite.fail(grades.tasks[task].name, fmt::format("{} of {} points: {}", points_text(grade.points),
                                                        points_text(grades.tasks[task].points), grade.lost));
    }
  }
  return junit_text(suites);
}

std::string gradescope_of(const Grades& grades, const StudentGrade& student) {
  // The first field marks the file as one that labmouse writes: Gradescope leaves `extra_data` to autograders.
  Json json = {{"extra_data", {{"labmouse", version()}}}, {"score", student.points}};
  if (!student.broken.empty()) {
    std::string output = shown(student.broken) + "\n";
    for (const std::string& line : student.output) output += fmt::format("  | {}\n", shown(line));
    json["output"] = output;
  }
  json["tests"] = Json::array();
  for (std::size_t task = 0; task < grades.tasks.size(); ++task) {
    const TaskGrade grade = for_student(student.tasks[task]);
    json["tests"].push_back({{"name", shown(grades.tasks[task].name)},
                             {"score", grade.points},
                             {"max_score", grades.tasks[task].points},
                             {"status", grade.lost.empty() ? "passed" : "failed"},
                             {"output", lines_of(grade, grades.unit)},
                             {"visibility", "visible"}});
  }
  return text_of(json);
}

}  // namespace labmouse
