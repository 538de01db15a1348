#include "labmouse/lab/grading/feedback_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/reports/race_page.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

// The policy of the page forbids styles in elements, but not these attributes.
constexpr std::string_view table = "<table border=\"1\" cellpadding=\"6\" cellspacing=\"0\">\n";

std::string row(std::string_view cell, const std::vector<std::string>& texts) {
  std::string html = "<tr>";
  for (const std::string& text : texts) html += fmt::format("<{0}>{1}</{0}>", cell, text);
  return html + "</tr>\n";
}

std::string number_text(const std::optional<double>& number) { return number ? fmt::format("{:.3f}", *number) : "-"; }

/// The contests of a task, a row each.
std::string contests_table(const TaskGrade& task, const std::string& unit) {
  std::string html(table);
  html += row("th", {"maze", "outcome", "score, " + unit, "best possible", "lost because"});
  for (const GradedContest& contest : task.contests) {
    std::string lost = xml_escaped(contest.lost);
    for (const std::string& line : contest.output) lost += "<br>" + xml_escaped(line);
    html += row("td", {xml_escaped(contest.maze), xml_escaped(contest.outcome), number_text(contest.score),
                       number_text(contest.best), lost});
  }
  return html + "</table>\n";
}

std::string points_table(const Grades& grades, const StudentGrade& student) {
  std::string html(table);
  html += row("th", {"task", "points", "of", "lost because"});
  for (std::size_t task = 0; task < grades.tasks.size(); ++task)
    html += row("td", {xml_escaped(grades.tasks[task].name), points_text(student.tasks[task].points),
                       points_text(grades.tasks[task].points), xml_escaped(for_student(student.tasks[task]).lost)});
  return html + "</table>\n";
}

/// Why a program is broken, and its output.
std::string lines_html(const StudentGrade& student) {
  std::string html = xml_escaped(student.broken);
  for (const std::string& line : student.output) html += "<br>" + xml_escaped(line);
  return html;
}

/// The points as HTML that needs no script.
std::string points_html(const Grades& grades, const StudentGrade& student, bool has_replays) {
  std::string html =
      fmt::format("<details id=\"labmouse-grade\" open>\n<summary><h1>{}: {} of {} points</h1></summary>\n",
                  xml_escaped(student.name), points_text(student.points), points_text(grades.points));
  if (!student.broken.empty()) html += fmt::format("<p>The program did not start: {}</p>\n", lines_html(student));
  html += points_table(grades, student);
  for (std::size_t task = 0; task < grades.tasks.size(); ++task)
    if (!student.tasks[task].contests.empty())
      html += fmt::format("<h2>{}</h2>\n", xml_escaped(grades.tasks[task].name)) +
              contests_table(for_student(student.tasks[task]), xml_escaped(grades.unit));
  if (has_replays) html += "<p>Below are the replays of these contests, step by step.</p>\n";
  return html + "</details>\n";
}

/// The part of a race that the student may see.
Race visible_part(const GradingPlan& plan, const Race& race) {
  Race visible;
  visible.order = race.order;
  visible.mice = race.mice;
  for (std::size_t maze = 0; maze < race.mazes.size(); ++maze) {
    if (plan.mazes[maze].hidden && !plan.file.show_hidden) continue;
    for (const ContestResult& contest : race.results) {
      if (contest.maze != maze) continue;
      visible.results.push_back(without_clock(contest, *race.world().traits().fields));
      visible.results.back().maze = visible.mazes.size();
    }
    visible.mazes.push_back(race.mazes[maze]);
    visible.facts.push_back(race.facts[maze]);
  }
  return visible;
}

}  // namespace

std::string feedback_page(const GradingPlan& plan, const Grades& grades, const StudentContests& contests,
                          const StudentGrade& student, std::string_view page) {
  const bool has_replays =
      std::any_of(contests.records.begin(), contests.records.end(), [](const auto& record) { return !record.empty(); });
  std::string text =
      contests.race ? race_page(visible_part(plan, *contests.race), contests.records, page) : std::string(page);
  constexpr std::string_view body = "<body>";
  const auto begin = text.find(body);
  // A page without a body, which HTML allows, begins with its head: the points come last there.
  const std::size_t at = begin == std::string::npos ? text.size() : begin + body.size();
  return text.insert(at, "\n" + points_html(grades, student, has_replays));
}

}  // namespace labmouse
