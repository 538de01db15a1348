// labmouse grade: the programs of a class, graded by the tasks of a course.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/external/sandbox.hpp"
#include "labmouse/lab/grading/class_contests.hpp"
#include "labmouse/lab/grading/feedback_page.hpp"
#include "labmouse/lab/grading/grade_files.hpp"
#include "labmouse/lab/grading/grade_table.hpp"
#include "labmouse/lab/mazes/secret_mazes.hpp"
#include "labmouse/lab/system/file_names.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "page.hpp"

namespace labmouse::cli {
namespace {

struct GradeOptions {
  std::string mice, tasks, seed_file, format = "table", junit, gradescope, feedback, page;
  int jobs = 0;
  ExternalOptions external_mice;
};

std::string described(const std::string& path, const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) text += (text.empty() ? "" : "\n") + describe(path, problem);
  return text;
}

std::string content_of(const std::string& path) {
  FileContent file = read_file(path);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", path, file.error));
  return std::move(file.content);
}

std::string secret_seed(const std::string& path) {
  std::string seed = secret_in(content_of(path));
  if (seed.size() < shortest_secret)
    throw UsageError(fmt::format(
        "{}: error: the seed has fewer than {} characters, so that it could be guessed; write a longer text", path,
        shortest_secret));
  return seed;
}

GradingPlan plan_of(const GradeOptions& options) {
  TaskFileResult read = read_task_file(content_of(options.tasks));
  if (!read.problems.empty()) throw UsageError(described(options.tasks, read.problems));
  if (!options.seed_file.empty()) {
    if (!read.file.seed.empty())
      throw UsageError(
          fmt::format("{}: error: has a seed, and --seed-file names another; remove one of them", options.tasks));
    read.file.seed = secret_seed(options.seed_file);
  }
  GradingPlan plan = plan_grading(std::move(read.file), options.tasks);
  if (!plan.errors.empty()) throw UsageError(fmt::format("{}", fmt::join(plan.errors, "\n")));
  tell_remarks(plan.remarks);
  return plan;
}

std::vector<Student> students_of(const GradeOptions& options, const GradingPlan& plan,
                                 const std::atomic<bool>& stopped) {
  ExternalOptions external_mice = options.external_mice;
  external_mice.limits = plan.file.limits.over(external_mice.limits);
  external_mice.runs = plan.file.runs.value_or(external_mice.runs);
  external_mice.stop = &stopped;
  if (external_mice.sandbox == SandboxUse::always && !why_no_sandbox().empty())
    throw UsageError(fmt::format("error: this system has no sandboxes ({}); leave out --sandbox on", why_no_sandbox()));
  const std::string text = content_of(options.mice);
  refuse_other_kind(options.mice, text, FileKind::unknown);
  ClassResult read = read_class(options.mice, text, external_mice);
  if (!read.problems.empty()) throw UsageError(described(options.mice, read.problems));
  return std::move(read.students);
}

/// The paths of the files of students.
struct StudentPaths {
  std::vector<std::string> gradescope, feedback;
};

/// The paths, which may hold earlier files of the same kind and no others. Throws UsageError.
StudentPaths paths_of(const GradeOptions& options, const std::vector<Student>& students) {
  std::vector<std::string> names;
  for (const Student& student : students) names.push_back(student.name);
  StudentPaths paths;
  for (const std::string& name : file_names(names)) {
    if (!options.gradescope.empty())
      paths.gradescope.push_back(fmt::format("{}/{}/results.json", options.gradescope, name));
    if (!options.feedback.empty()) paths.feedback.push_back(fmt::format("{}/{}.html", options.feedback, name));
  }
  for (const std::string& path : paths.gradescope) {
    keep_other_files("--gradescope", FileKind::gradescope, path);
    require_writable(path);
  }
  for (const std::string& path : paths.feedback) {
    keep_other_files("--feedback", FileKind::page, path);
    require_writable(path);
  }
  return paths;
}

/// Runs the contests of all students, with a progress bar.
ClassContests held(const GradeOptions& options, const GradingPlan& plan, const std::vector<Student>& students,
                   const std::atomic<bool>& stopped) {
  Progress progress;
  ClassOrder order;
  order.jobs = options.jobs;
  order.keep_records = !options.feedback.empty();
  order.files = {options.seed_file, options.junit, options.gradescope, options.feedback};
  order.stop = &stopped;
  order.advanced = [&](std::size_t all) { progress.advance(all); };
  return run_class(plan, students, order);
}

int grade(const GradeOptions& options) {
  const std::string page = options.feedback.empty() ? "" : find_page(options.page);
  expect_outputs({{"--junit", options.junit, FileKind::junit},
                  {"--mice", options.mice},
                  {"--tasks", options.tasks},
                  {"--seed-file", options.seed_file},
                  {"--page", options.page}});
  const GradingPlan plan = plan_of(options);
  std::optional<Interruptible> interruptible(std::in_place);
  const std::vector<Student> students = students_of(options, plan, interruptible->stopped());
  const StudentPaths paths = paths_of(options, students);
  const ClassContests contests = held(options, plan, students, interruptible->stopped());
  interruptible.reset();
  if (contests.stopped) {
    tell("Stopped early: nobody is graded.\n");
    return exit_interrupted();
  }
  const Grades grades = grades_of(plan, contests);
  if (!options.junit.empty()) save(options.junit, junit_of(grades));
  for (std::size_t i = 0; i < paths.gradescope.size(); ++i)
    save(paths.gradescope[i], gradescope_of(grades, grades.students[i]));
  for (std::size_t i = 0; i < paths.feedback.size(); ++i)
    save(paths.feedback[i], feedback_page(plan, grades, contests.students[i], grades.students[i], page));
  print(options.format == "csv" ? csv_of(grades) : options.format == "json" ? json_of(grades) : table_of(grades));
  if (grades.not_judged == 0) return exit_good;
  tell(fmt::format("{} not judged, because the machine was too busy; they count as lost, so grade again\n",
                   counted(grades.not_judged, "contest was", "contests were")));
  return exit_finding;
}

}  // namespace

void add_grade(Command& app, int& exit) {
  auto options = std::make_shared<GradeOptions>();
  Command* command = app.add_subcommand("grade", "Grade the programs of a class by tasks with points");
  command->group(groups::mice);
  command
      ->add_option("--mice,--mice-file", options->mice,
                   "Mice file of the class: a name and a program for each student, as docs/reference/files.md explains")
      ->required()
      ->type_name("FILE");
  command->group(groups::contests);
  command
      ->add_option("--tasks", options->tasks,
                   "Task file: tasks with points, mazes and requirements, as docs/reference/files.md explains")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--seed-file", options->seed_file,
                   "File with the secret seed of hidden mazes, where the task file has none; - is standard input")
      ->type_name("FILE");
  command->add_option("--jobs", options->jobs, "Number of threads; 0 uses all processors")
      ->check(in_range(0, 1024))
      ->capture_default_str();
  command->group(groups::output);
  command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json", "csv"}))
      ->capture_default_str();
  command->add_option("--junit", options->junit, "Write JUnit XML: a suite for each student, with a test for each task")
      ->type_name("FILE");
  command
      ->add_option("--gradescope", options->gradescope,
                   "Folder for the results.json of each student, as autograders of Gradescope write it")
      ->type_name("DIR");
  auto* feedback = command
                       ->add_option("--feedback", options->feedback,
                                    "Folder for a page for each student: what was lost where, with replays")
                       ->type_name("DIR");
  command->add_option("--page", options->page, "Use this page for --feedback instead of the built-in one")
      ->type_name("FILE")
      ->needs(feedback);
  add_runners(*command, options->external_mice);
  add_external_options(*command, options->external_mice);
  command->footer(
      "Example: labmouse grade --mice class.toml --tasks tasks.toml --feedback feedback\n"
      "         labmouse grade --mice class.toml --tasks tasks.toml --seed-file seed.txt --format csv > grades.csv");
  command->callback([options, &exit] { exit = grade(*options); });
}

}  // namespace labmouse::cli
