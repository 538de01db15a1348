// labmouse robot fit, labmouse robot compare: from turns that were measured, and logs that a mouse wrote.
#include "robot_fit.hpp"

#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "labmouse/lab/logs/log_comparison.hpp"
#include "labmouse/lab/logs/log_robot.hpp"
#include "labmouse/lab/robots/fitted_robot.hpp"
#include "labmouse/lab/system/files.hpp"

namespace labmouse::cli {
namespace {

constexpr std::size_t most_log_bytes = std::size_t{1} << 27U;

struct LogOptions {
  std::string path;
  std::string columns;
  double period = 0.0;
};

struct FitOptions {
  std::string turns;
  LogOptions log;
  std::string base = "classic";
  double cell = 0.0;
  double way = 0.0, way_error = 1.0;
};

struct CompareOptions {
  LogOptions log;
  std::string robot = "classic";
  std::string svg;
};

std::string content_or_refuse(const std::string& path, std::size_t most_bytes) {
  FileContent file = read_file(path, most_bytes);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", path, file.error));
  return std::move(file.content);
}

void refuse(const std::string& path, const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) text += (text.empty() ? "" : "\n") + describe(path, problem);
  if (!text.empty()) throw UsageError(text);
}

Log log_or_refuse(const LogOptions& options) {
  if (options.columns.empty())
    throw UsageError("error: --columns must say which column is what, as in time=ms,left=pwm_l/255,gyro*0.001");
  const LogColumnsResult columns = read_log_columns(options.columns, options.period);
  if (!columns.error.empty()) throw UsageError(fmt::format("error: --columns: {}", columns.error));
  LogResult result = read_log(content_or_refuse(options.path, most_log_bytes), columns.columns);
  refuse(options.path, result.problems);
  return std::move(result.log);
}

FittedRobot fit_turns(const FitOptions& options, const Robot& base) {
  const TurnTable table = read_turn_table(content_or_refuse(options.turns, std::size_t{1} << 20U));
  refuse(options.turns, table.problems);
  const double known = options.cell > 0.0 ? options.cell : cell_of(table.turns);
  return fitted_robot(table.turns, base, known > 0.0 ? known : base.cell);
}

int fit(const FitOptions& options) {
  if (options.turns.empty() == options.log.path.empty())
    throw UsageError("error: name one of --turns and --log, which say what to fit");
  const std::string& path = options.turns.empty() ? options.log.path : options.turns;
  const Robot base = find_robot_or_refuse(options.base).robot;
  const FittedRobot fitted =
      options.turns.empty() ? robot_by_log(log_or_refuse(options.log), path, base, {options.way, options.way_error})
                            : fit_turns(options, base);
  if (!fitted.error.empty()) throw UsageError(fmt::format("{}: error: {}", path, fitted.error));
  print(fitted.text);
  if (fitted.doubt.empty()) return exit_good;
  tell(fmt::format("{}: {}\n", path, fitted.doubt));
  return exit_finding;
}

int compare(const CompareOptions& options) {
  expect_outputs({{"the log", options.log.path, Output::Kind::input}, {"--svg", options.svg}});
  const FoundRobot robot = find_robot_or_refuse(options.robot);
  if (!robot.robot.hardware)
    throw UsageError(
        fmt::format("error: {} does not say what it is built of, so it cannot be driven; take one that "
                    "does, such as classic or kerise",
                    options.robot));
  const LogComparison comparison = compare_log(log_or_refuse(options.log), robot.robot);
  if (!comparison.error.empty()) throw UsageError(fmt::format("{}: error: {}", options.log.path, comparison.error));
  print(table_of(comparison, options.log.path, options.robot));
  if (!options.svg.empty()) save(options.svg, picture_of(comparison, options.log.path, options.robot));
  return exit_good;
}

void add_columns(Command& command, LogOptions& options) {
  command
      .add_option("--columns", options.columns,
                  "Which column of the log is what: ROLE=COLUMN, with a factor or divisor behind it, separated by "
                  "commas (docs/logs.md has the roles)")
      ->type_name("LIST");
  command
      .add_option("--period", options.period, "From one row of the log to the next in ms, where no column has the time")
      ->type_name("MS")
      ->check(in_range(0.05, 50.0));
}

void add_fit(Command& robot, int& exit) {
  auto options = std::make_shared<FitOptions>();
  Command* command =
      robot.add_subcommand("fit", "Write a robot file from published or measured turns, or from a log of a mouse");
  command->add_option("--turns", options->turns, "Table of turns: columns turn, speed, ms, x, y, before, after")
      ->type_name("TABLE");
  command->add_option("--log", options->log.path, "Log of a mouse, CSV")->type_name("FILE");
  add_columns(*command, options->log);
  command
      ->add_option("--way", options->way,
                   "How far the mouse came in the whole log, in mm, where no column has a way that is known")
      ->type_name("MM")
      ->check(in_range(1.0, 1e6));
  command->add_option("--way-error", options->way_error, "Standard error of that")
      ->type_name("MM")
      ->check(in_range(0.0, 1e4))
      ->capture_default_str();
  command->add_option("--base", options->base, "Robot that all other numbers are taken from")
      ->type_name("ROBOT")
      ->capture_default_str();
  command
      ->add_option(
          "--cell", options->cell,
          "With --turns: side of a cell in mm; default: what S90 with its straights says, or that of the other "
          "robot")
      ->type_name("MM")
      ->check(in_range(20.0, 1000.0));
  command->footer(
      "Example: labmouse robot fit --turns turns.txt --base kerise > my-mouse.toml\n"
      "         labmouse robot fit --log run.csv --columns time=ms,left=pwm_l/255,right=pwm_r/255,left_count=enc_l,"
      "right_count=enc_r,gyro=gz*0.00107 --base kerise > my-mouse.toml");
  command->callback([options, &exit] { exit = fit(*options); });
}

void add_compare(Command& robot, int& exit) {
  auto options = std::make_shared<CompareOptions>();
  Command* command = robot.add_subcommand("compare", "Drive a robot beside a log of a mouse: how far they differ");
  command->add_option("log", options->log.path, "Log of a mouse, CSV")->required()->type_name("FILE");
  add_columns(*command, options->log);
  add_robot_option(*command, options->robot);
  command->add_option("--svg", options->svg, "Save a picture of both, too")->type_name("FILE");
  command->footer(
      "Example: labmouse robot compare run.csv --columns time=ms,left=l,right=r,gyro --robot my-mouse.toml");
  command->callback([options, &exit] { exit = compare(*options); });
}

}  // namespace

void add_robot_fit(Command& robot, int& exit) {
  add_fit(robot, exit);
  add_compare(robot, exit);
}

}  // namespace labmouse::cli
