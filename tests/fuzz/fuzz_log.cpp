// Any bytes as a log: their first line as the columns, the rest as its text. There are rows or a problem, fits end with
// numbers that a file can have, and a robot drives beside it.
#include <cmath>

#include "labmouse/lab/logs/log_comparison.hpp"
#include "labmouse/lab/logs/log_robot.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "tests/fuzz/check_reader.hpp"

namespace {

using labmouse::fuzz::require;

void check_fit(const labmouse::Log& log, const labmouse::Robot& base) {
  for (const labmouse::WholeWay& whole : {labmouse::WholeWay{}, labmouse::WholeWay{1000.0, 1.0}}) {
    const labmouse::FittedRobot fitted = labmouse::robot_by_log(log, "log", base, whole);
    require(fitted.text.empty() != fitted.error.empty());
    if (!fitted.text.empty()) require(labmouse::read_robot(fitted.text, "fitted").robot.has_value());
  }
}

void check_comparison(const labmouse::Log& log, const labmouse::Robot& robot) {
  const labmouse::LogComparison comparison = labmouse::compare_log(log, robot);
  if (!comparison.error.empty()) return;
  for (const labmouse::ComparedCurve* curve : {&comparison.speed, &comparison.yaw, &comparison.way, &comparison.turn}) {
    require(curve->log.size() == curve->robot.size());
    for (const double value : curve->robot) require(std::isfinite(value));
  }
  require(!labmouse::table_of(comparison, "log", "robot").empty());
  require(!labmouse::picture_of(comparison, "log", "robot").empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const labmouse::Robot robot = labmouse::find_robot("kerise").robot;
  const std::string_view all(reinterpret_cast<const char*>(bytes), size);
  const std::string_view words = all.substr(0, all.find('\n'));
  for (const double period : {0.0, 5.0}) {
    const labmouse::LogColumnsResult columns = labmouse::read_log_columns(words, period);
    if (!columns.error.empty()) continue;
    const labmouse::LogResult read = labmouse::read_log(all.substr(std::min(size, words.size() + 1)), columns.columns);
    require(read.problems.size() <= 1);
    require(read.problems.empty() == (read.log.times.size() >= 2));
    if (!read.problems.empty()) continue;
    check_fit(read.log, robot);
    check_comparison(read.log, robot);
  }
  return 0;
}
