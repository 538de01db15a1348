#include "labmouse/lab/grading/grade_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::size_t column = 8;  // characters of a column of points

std::string heading_of(const Grades& grades) {
  std::string text = fmt::format("{}, {}, {} points\n", counted(grades.students.size(), "student", "students"),
                                 counted(grades.tasks.size(), "task", "tasks"), points_text(grades.points));
  for (std::size_t task = 0; task < grades.tasks.size(); ++task)
    text += fmt::format("{:>4}  {} ({})\n", task + 1, shown(grades.tasks[task].name),
                        points_text(grades.tasks[task].points));
  return text;
}

/// Why a student has not all points: one line for a broken program, else one for each task.
std::string losses_of(const StudentGrade& student) {
  const std::string name = shown(student.name);
  std::string text;
  if (!student.broken.empty()) {
    text = fmt::format("  {}: {}\n", name, shown(student.broken));
    for (const std::string& line : student.output) text += fmt::format("    | {}\n", shown(line));
    return text;
  }
  for (std::size_t task = 0; task < student.tasks.size(); ++task)
    if (!student.tasks[task].lost.empty())
      text += fmt::format("  {}, task {}: {}\n", name, task + 1, shown(student.tasks[task].lost));
  return text;
}

Json json_of(const GradedContest& contest) {
  Json json = {{"maze", contest.maze}, {"run", contest.run + 1}, {"outcome", contest.outcome}};
  json["score"] = contest.score ? Json(*contest.score) : Json(nullptr);
  json["best"] = contest.best ? Json(*contest.best) : Json(nullptr);
  json["lost"] = contest.lost;
  json["output"] = contest.output;
  return json;
}

Json json_of(const StudentGrade& student) {
  Json json = {{"name", student.name}, {"points", student.points}, {"broken", student.broken}};
  json["output"] = student.output;
  json["tasks"] = Json::array();
  for (const TaskGrade& task : student.tasks) {
    Json& one = json["tasks"].emplace_back(Json{{"points", task.points}, {"lost", task.lost}});
    one["contests"] = Json::array();
    for (const GradedContest& contest : task.contests) one["contests"].push_back(json_of(contest));
  }
  return json;
}

}  // namespace

std::string table_of(const Grades& grades) {
  std::size_t width = std::string_view("student").size();
  for (const StudentGrade& student : grades.students) width = std::max(width, printable(student.name).size());
  const auto line = [&](const std::string& name, const std::vector<std::string>& cells) {
    std::string text = name + std::string(width - printable(name).size(), ' ');
    for (const std::string& cell : cells) text += fmt::format("{:>{}}", cell, column);
    return text + "\n";
  };
  std::vector<std::string> cells;
  for (std::size_t task = 0; task < grades.tasks.size(); ++task) cells.push_back(fmt::format("{}", task + 1));
  cells.emplace_back("points");
  std::string text = heading_of(grades) + "\n" + line("student", cells), losses;
  for (const StudentGrade& student : grades.students) {
    cells.clear();
    for (const TaskGrade& task : student.tasks) cells.push_back(points_text(task.points));
    cells.push_back(points_text(student.points));
    text += line(shown(student.name), cells);
    losses += losses_of(student);
  }
  if (!losses.empty()) text += "\nLost points:\n" + losses;
  return text + "\n" + grades.notes;
}

std::string csv_of(const Grades& grades) {
  std::string text = "student";
  for (const GradedTask& task : grades.tasks) text += "," + csv_field(task.name);
  text += ",points\n";
  for (const StudentGrade& student : grades.students) {
    text += csv_field(student.name);
    for (const TaskGrade& task : student.tasks) text += fmt::format(",{}", task.points);
    text += fmt::format(",{}\n", student.points);
  }
  return text;
}

std::string json_of(const Grades& grades) {
  Json json = {{"labmouse", version()}, {"unit", grades.unit}, {"points", grades.points}};
  json["not_judged"] = grades.not_judged;
  json["notes"] = grades.notes;
  json["tasks"] = Json::array();
  for (const GradedTask& task : grades.tasks) json["tasks"].push_back({{"name", task.name}, {"points", task.points}});
  json["students"] = Json::array();
  for (const StudentGrade& student : grades.students) json["students"].push_back(json_of(student));
  return text_of(json);
}

}  // namespace labmouse
