// labmouse robot fit: writes a robot file from measured turns or logs. labmouse robot compare: compares a robot with a
// log.
#include "robot_fit.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "command.hpp"
#include "labmouse/lab/system/calls.hpp"

namespace labmouse::cli {
namespace {

/// The first argument is the function, the others are its command line.
constexpr const char* fit_in_python = R"python(import sys
try:
    from labmouse.fit import _commands
except ImportError as missing:
    hint = "" if "pip install" in str(missing) else "; run pip install -v '.[fit]' in the source folder of labmouse"
    print(f"error: labmouse robot {sys.argv[1]} needs labmouse for Python: {missing}{hint} ({sys.executable})", file=sys.stderr)
    sys.exit(2)
sys.exit(getattr(_commands, sys.argv[1])(sys.argv[2:])))python";

/// Replaces this process by Python; returns only by throwing UsageError.
[[noreturn]] void hand_over(const std::string& name, const std::vector<std::string>& words) {
  const std::string python = python_of_fits();
  std::vector<std::string> line = {python, "-c", fit_in_python, name};
  line.insert(line.end(), words.begin(), words.end());
  // Keeps modules in the current folder from replacing real ones.
  const int failure = become_program(std::move(line), {"PYTHONSAFEPATH=1"});
  throw UsageError(fmt::format("error: labmouse robot {} needs Python: {}: {}", name, python,
                               std::generic_category().message(failure)));
}

void add(Command& robot, const std::string& name, const std::string& meaning, const std::string& example) {
  Command* command = robot.add_subcommand(name, meaning);
  command->footer(
      fmt::format("Labmouse for Python does this: `python3 -m labmouse.fit{} --help` lists the options.\n\n"
                  "Example: labmouse robot {} {}",
                  name == "fit" ? "" : "." + name, name, example));
  command->hand_over([name](const std::vector<std::string>& words) { hand_over(name, words); });
}

}  // namespace

std::string python_of_fits() {
  const char* chosen = std::getenv("LABMOUSE_PYTHON");
  return chosen != nullptr && *chosen != '\0' ? chosen : "python3";
}

void add_robot_fit(Command& robot) {
  add(robot, "fit",
      "Write a robot file from published or measured turns, from a header of firmware, or from logs of a mouse",
      "--turns turns.txt --base kerise > my-mouse.toml\n"
      "         labmouse robot fit --turns config-robot.h --base beginner > my-mouse.toml\n"
      "         labmouse robot fit run.csv --columns time=ms,left=pwm_l/255,right=pwm_r/255,left_count=enc_l,"
      "right_count=enc_r,gyro=gz*0.00107 --base kerise > my-mouse.toml");
  add(robot, "compare", "Drive a robot beside a log of a mouse: how far they differ",
      "run.csv --columns time=ms,left=l,right=r,gyro --robot my-mouse.toml");
}

}  // namespace labmouse::cli
