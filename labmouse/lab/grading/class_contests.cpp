#include "labmouse/lab/grading/class_contests.hpp"

#include <algorithm>
#include <map>

#include "labmouse/contest/action_errors.hpp"
#include "labmouse/lab/races/race_order.hpp"
#include "labmouse/mouse/action.hpp"

namespace labmouse {
namespace {

/// Whether the program did not start in time, or did not answer: it would probably do so in each maze.
bool has_hung(const ContestResult& contest) {
  const auto ended_by = [&](ForfeitReason reason) { return contest.outcome.ends_with(name_of(reason)); };
  const bool slow_start =
      !contest.never_started.empty() && (ended_by(ForfeitReason::late) || ended_by(ForfeitReason::out_of_time));
  return contest.done && (ended_by(ForfeitReason::hung) || slow_start);
}

/// One contest with what is kept of it.
struct RunContest {
  ContestResult result;
  std::optional<int> known_wall_hits;
  std::string record;
};

/// Runs some of the contests, and hands them to the students.
class ClassRun {
 public:
  ClassRun(const GradingPlan& plan, const ClassOrder& order) : plan_(plan), order_(order) {
    race_order_.world = plan.world;
    race_order_.runs = plan.file.runs.value_or(plan.file.world.entry->usual_runs);
    race_order_.jobs = order.jobs;
    race_order_.files = plan.files;
    race_order_.files.insert(race_order_.files.end(), order.files.begin(), order.files.end());
    facts_.resize(plan.mazes.size());
  }

  std::size_t contests(const std::vector<Contestant>& mice, std::size_t mazes) const {
    return contests_of(mice, mazes, race_order_);
  }

  /// Runs the mice in the mazes from `begin` to before `end`. Returns whether all contests were done.
  bool run(std::vector<Contestant> mice, std::size_t begin, std::size_t end, std::size_t all) {
    if (mice.empty() || begin == end) return true;
    std::vector<std::size_t> places;
    for (std::size_t maze = begin; maze < end; ++maze) places.push_back(maze);
    std::sort(places.begin(), places.end(),
              [&](std::size_t a, std::size_t b) { return in_race_order(plan_.mazes[a].maze, plan_.mazes[b].maze); });
    std::vector<NamedMaze> mazes;
    for (const std::size_t place : places) mazes.push_back(plan_.mazes[place].maze);
    std::vector<RunContest> held(contests(mice, mazes.size()));
    RaceHooks hooks;
    hooks.stop = order_.stop;
    hooks.keep = [&](const ContestResult& contest) {
      const bool visible = plan_.file.show_hidden || !plan_.mazes[places[contest.maze]].hidden;
      return Keep{order_.keep_records && visible && contest.run == 0, false};
    };
    hooks.finished = [&](const Race& race, const ContestResult& contest, const ContestOutput& output) {
      RunContest& one = held[static_cast<std::size_t>(&contest - race.results.data())];
      one.record = output.record;
      if (output.run)
        one.known_wall_hits = labmouse::known_wall_hits(*output.run, race.mazes[contest.maze].maze.size());
      if (order_.advanced) order_.advanced(all);
    };
    Race race = hold_race(std::move(mice), std::move(mazes), race_order_, hooks);
    for (std::size_t i = 0; i < race.facts.size(); ++i) facts_[places[i]] = race.facts[i];
    for (std::size_t i = 0; i < race.results.size(); ++i) {
      held[i].result = std::move(race.results[i]);
      const std::string& mouse = race.mice[held[i].result.mouse].name;
      held[i].result.mouse = 0;
      held[i].result.maze = places[held[i].result.maze];
      of_[mouse].push_back(std::move(held[i]));
    }
    return !race.stopped;
  }

  /// The maze in which the mouse hung; empty where it did not.
  std::string hung_in(const std::string& mouse) const {
    const auto found = of_.find(mouse);
    if (found == of_.end()) return "";
    const bool hung = std::any_of(found->second.begin(), found->second.end(),
                                  [](const RunContest& contest) { return has_hung(contest.result); });
    return hung ? plan_.mazes.front().maze.name : "";
  }

  void hand_over(const Contestant& mouse, StudentContests& student) {
    std::vector<RunContest>& contests = of_[mouse.name];
    std::sort(contests.begin(), contests.end(), [](const RunContest& a, const RunContest& b) {
      return std::pair(a.result.maze, a.result.run) < std::pair(b.result.maze, b.result.run);
    });
    Race& race = student.race.emplace();
    race.order = race_order_;
    race.mice = {mouse};
    for (const GradedMaze& maze : plan_.mazes) race.mazes.push_back(maze.maze);
    race.facts = facts_;
    for (RunContest& contest : contests) {
      race.results.push_back(std::move(contest.result));
      student.known_wall_hits.push_back(contest.known_wall_hits);
      student.records.push_back(std::move(contest.record));
    }
  }

 private:
  const GradingPlan& plan_;
  const ClassOrder& order_;
  RaceOrder race_order_;
  std::vector<MazeFacts> facts_;
  std::map<std::string, std::vector<RunContest>> of_;  ///< by the name of the mouse
};

}  // namespace

ClassContests run_class(const GradingPlan& plan, const std::vector<Student>& students, const ClassOrder& order) {
  ClassContests held;
  for (const Student& student : students) {
    StudentContests& contests = held.students.emplace_back();
    contests.name = student.name;
    contests.broken = student.mouse ? plan.world->refuse(*student.mouse) : student.broken;
    if (contests.broken.empty()) held.mice.push_back(*student.mouse);
  }
  ClassRun run(plan, order);
  const std::size_t all = run.contests(held.mice, plan.mazes.size());
  held.stopped = !run.run(held.mice, 0, 1, all);
  std::vector<Contestant> others;
  for (const Contestant& mouse : held.mice)
    if (run.hung_in(mouse.name).empty()) others.push_back(mouse);
  if (!held.stopped) held.stopped = !run.run(std::move(others), 1, plan.mazes.size(), all);
  if (held.stopped) return held;
  for (std::size_t i = 0; i < students.size(); ++i) {
    if (!held.students[i].broken.empty()) continue;
    held.students[i].hung_in = run.hung_in(students[i].name);
    run.hand_over(*students[i].mouse, held.students[i]);
  }
  return held;
}

}  // namespace labmouse
