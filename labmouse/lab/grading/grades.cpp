#include "labmouse/lab/grading/grades.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// A mean such as 1.3 may be off by the rounding of its sum.
constexpr double rounding = 1e-9;

constexpr std::string_view not_run_outcome = "not run";

/// One contest of a student in a maze of the task; `held` is null where it was not run.
struct Judged {
  std::size_t maze = 0;
  const ContestResult* held = nullptr;
  std::optional<int> known_wall_hits;
};

/// Judges the contests of one student.
class Judge {
 public:
  Judge(const GradingPlan& plan, const StudentContests& student) : plan_(plan), student_(student) {}

  TaskGrade grade(const Task& task, const std::vector<std::size_t>& mazes) {
    const std::vector<Judged> contests = contests_in(mazes);
    TaskGrade grade;
    std::size_t good = 0;
    std::string first;
    for (const Judged& contest : contests) {
      GradedContest& one = grade.contests.emplace_back(described(contest));
      one.lost = why_lost(task, {contest}, task.finish);
      if (one.lost.empty())
        ++good;
      else if (first.empty())
        first = fmt::format("{}: {}", one.maze, one.lost);
    }
    if (task.per_maze) {
      grade.points = task.points * static_cast<double>(good) / static_cast<double>(contests.size());
      if (good < contests.size())
        grade.lost = fmt::format("in {} of {}, the first in {}", contests.size() - good,
                                 counted(contests.size(), "contest", "contests"), first);
      return grade;
    }
    grade.lost = why_lost(task, contests, task.finish);
    if (grade.lost.empty()) grade.points = task.points;
    return grade;
  }

 private:
  std::vector<Judged> contests_in(const std::vector<std::size_t>& mazes) const {
    std::vector<Judged> contests;
    const std::vector<ContestResult>& all = student_.race->results;
    for (const std::size_t maze : mazes) {
      const std::size_t before = contests.size();
      for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].maze == maze) contests.push_back({maze, &all[i], student_.known_wall_hits[i]});
      if (contests.size() == before) contests.push_back({maze, nullptr, {}});
    }
    return contests;
  }

  std::string not_run() const { return fmt::format("not run, because the program hung in {}", student_.hung_in); }

  GradedContest described(const Judged& contest) const {
    const GradedMaze& maze = plan_.mazes[contest.maze];
    GradedContest one;
    one.maze = maze.maze.name;
    one.hidden = maze.hidden && !plan_.file.show_hidden;
    one.best = student_.race->facts[contest.maze].bound;
    one.outcome = contest.held != nullptr ? contest.held->outcome : std::string(not_run_outcome);
    if (contest.held == nullptr) return one;
    one.run = contest.held->run;
    one.score = contest.held->score;
    if (is_broken(*contest.held) && !one.hidden) one.output = output_of(*contest.held);
    return one;
  }

  std::vector<std::string> output_of(const ContestResult& contest) const {
    const Value said = figure_of(*student_.race, contest, said_last);
    if (!std::holds_alternative<std::string>(said)) return {};
    const std::string& words = std::get<std::string>(said);
    std::vector<std::string> lines = {words.substr(0, words.find('\n'))};
    if (const auto end = words.find('\n'); end != std::string::npos)
      for (std::string& line : last_lines(std::string_view(words).substr(end))) lines.push_back(std::move(line));
    return lines;
  }

  /// Whether the program failed, so that the contest fulfils nothing: neither did it hit a wall.
  static bool is_broken(const ContestResult& contest) {
    return !contest.score && (!contest.never_started.empty() || contest.outcome.starts_with("forfeit"));
  }

  /// Why these contests together do not fulfil the task; empty where they do.
  std::string why_lost(const Task& task, const std::vector<Judged>& contests, bool finish) const {
    std::string reasons;
    const auto add = [&](const std::string& reason) { reasons += (reasons.empty() ? "" : "; ") + reason; };
    if (const std::string reason = failures(contests, finish); !reason.empty()) add(reason);
    for (const FigureLimit& limit : task.at_most)
      if (const std::string reason = above(limit, contests); !reason.empty()) add(reason);
    return reasons;
  }

  /// The contests that no figure can make good, and the first of them.
  std::string failures(const std::vector<Judged>& contests, bool finish) const {
    std::size_t failed = 0;
    std::string first;
    for (const Judged& contest : contests) {
      std::string reason;
      if (contest.held == nullptr)
        reason = not_run();
      else if (!contest.held->judged || is_broken(*contest.held) || (finish && !contest.held->score))
        reason = contest.held->outcome;
      if (reason.empty()) continue;
      if (failed++ == 0) first = contests.size() > 1 ? plan_.mazes[contest.maze].maze.name + ": " + reason : reason;
    }
    if (failed == 0 || contests.size() == 1) return first;
    return fmt::format("failed {} of {}, the first in {}", failed, counted(contests.size(), "contest", "contests"),
                       first);
  }

  /// Says by how much the mean of a figure is above its limit; nothing where it is not, or where failures say it all.
  std::string above(const FigureLimit& limit, const std::vector<Judged>& contests) const {
    double sum = 0.0;
    for (const Judged& contest : contests) {
      if (contest.held == nullptr || !contest.held->judged || is_broken(*contest.held)) return "";
      const std::optional<double> number = figure(limit.figure, contest);
      if (!number) return fmt::format("no {} in {}", limit.figure, plan_.mazes[contest.maze].maze.name);
      sum += *number;
    }
    const double mean = sum / static_cast<double>(contests.size());
    if (mean <= limit.most + rounding * std::max(1.0, std::abs(limit.most))) return "";
    return fmt::format("{}{} {:.4g} is above {:g}", contests.size() > 1 ? "mean " : "", limit.figure, mean, limit.most);
  }

  /// The figure of a contest; without a score, that of the score at the limit, as in comparisons.
  std::optional<double> figure(const std::string& name, const Judged& contest) const {
    const Race& race = *student_.race;
    const double limit = race.world().traits().limit_score;
    if (name == score_figure) return contest.held->score.value_or(limit);
    if (name == ratio_figure) {
      const std::optional<double>& best = race.facts[contest.maze].bound;
      if (contest.held->score) return contest.held->ratio;
      return best ? std::optional(limit / *best) : std::nullopt;
    }
    if (name == known_wall_hits_figure) return contest.known_wall_hits;
    const Value value = figure_of(race, *contest.held, name);
    // Fields are left out where nothing of their kind happened.
    return std::holds_alternative<std::monostate>(value) ? 0.0 : number_of(value);
  }

  const GradingPlan& plan_;
  const StudentContests& student_;
};

/// Why the program started in no contest; empty where it did in one.
std::string why_never_started(const Race& race) {
  for (const ContestResult& contest : race.results)
    if (contest.never_started.empty()) return "";
  return race.results.empty() ? "" : race.results.front().never_started;
}

/// A program that never started fails in the same way in each contest, so the output is kept once.
void gather_output(StudentGrade& grade) {
  for (TaskGrade& task : grade.tasks)
    for (GradedContest& contest : task.contests) {
      if (grade.output.empty() && contest.output.size() > 1)
        grade.output.assign(contest.output.begin() + 1, contest.output.end());
      contest.output.clear();
    }
}

StudentGrade grade_of(const GradingPlan& plan, const StudentContests& student) {
  StudentGrade grade;
  grade.name = student.name;
  grade.broken = student.race ? why_never_started(*student.race) : student.broken;
  for (std::size_t task = 0; task < plan.file.tasks.size(); ++task) {
    if (!student.race) {
      grade.tasks.emplace_back().lost = student.broken;
      continue;
    }
    grade.tasks.push_back(Judge(plan, student).grade(plan.file.tasks[task], plan.mazes_of[task]));
    grade.points += grade.tasks.back().points;
  }
  if (!grade.broken.empty()) gather_output(grade);
  return grade;
}

}  // namespace

std::string points_text(double points) {
  std::string text = fmt::format("{:.2f}", points);
  text.erase(text.find_last_not_of('0') + 1);
  return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

TaskGrade for_student(TaskGrade grade) {
  std::size_t lost = 0;
  bool hides = false;
  for (GradedContest& contest : grade.contests) {
    lost += contest.lost.empty() ? 0 : 1;
    if (!contest.hidden) continue;
    hides = true;
    // Why a contest was not run says nothing of its maze, while other reasons have figures.
    if (!contest.lost.empty() && contest.outcome != not_run_outcome)
      contest.lost = contest.score ? "not fulfilled" : contest.outcome;
    contest.score.reset();
    contest.best.reset();
  }
  if (hides && !grade.lost.empty())
    grade.lost = fmt::format("not fulfilled in {} of {}", lost, counted(grade.contests.size(), "contest", "contests"));
  return grade;
}

Grades grades_of(const GradingPlan& plan, const ClassContests& contests) {
  Grades grades;
  for (const Task& task : plan.file.tasks) {
    grades.tasks.push_back({task.name, task.points});
    grades.points += task.points;
  }
  grades.unit = plan.world->traits().unit;
  for (const StudentContests& student : contests.students) {
    grades.students.push_back(grade_of(plan, student));
    if (student.race)
      grades.not_judged +=
          static_cast<int>(std::count_if(student.race->results.begin(), student.race->results.end(),
                                         [](const ContestResult& contest) { return contest.done && !contest.judged; }));
  }
  grades.notes = score_note(*plan.world) + sandbox_note(contests.mice);
  return grades;
}

}  // namespace labmouse
