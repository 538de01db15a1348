// Any bytes as a log: their first line as the columns, the rest as its text. There are rows or a problem, fits end with
// numbers that a file can have, and a robot drives beside it.
#include <cmath>

#include "labmouse/lab/logs/log_comparison.hpp"
#include "labmouse/lab/logs/log_robot.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

void check_fit(const Log& log, const Robot& base) {
  for (const WholeWay& whole : {WholeWay{}, WholeWay{1000.0, 1.0}}) {
    const FittedRobot fitted = robot_by_log(log, "log", base, whole);
    require(fitted.text.empty() != fitted.error.empty());
    if (!fitted.text.empty()) require(read_robot(fitted.text, "fitted").robot.has_value());
  }
}

void check_comparison(const Log& log, const Robot& robot) {
  const LogComparison comparison = compare_log(log, robot);
  if (!comparison.error.empty()) return;
  for (const ComparedCurve* curve : {&comparison.speed, &comparison.yaw, &comparison.way, &comparison.turn}) {
    require(curve->log.size() == curve->robot.size());
    for (const double value : curve->robot) require(std::isfinite(value));
  }
  require(!table_of(comparison, "log", "robot").empty());
  require(!picture_of(comparison, "log", "robot").empty());
}

}  // namespace

LABMOUSE_FUZZER(log) {
  static const Robot robot = find_robot("kerise").robot;
  const std::string_view all(reinterpret_cast<const char*>(bytes), size);
  const std::string_view words = all.substr(0, all.find('\n'));
  for (const double period : {0.0, 5.0}) {
    const LogColumnsResult columns = read_log_columns(words, period);
    if (!columns.error.empty()) continue;
    const LogResult read = read_log(all.substr(std::min(size, words.size() + 1)), columns.columns);
    require(read.problems.size() <= 1);
    require(read.problems.empty() == (read.log.times.size() >= 2));
    if (!read.problems.empty()) continue;
    check_fit(read.log, robot);
    check_comparison(read.log, robot);
  }
  return 0;
}

}  // namespace labmouse::fuzz
