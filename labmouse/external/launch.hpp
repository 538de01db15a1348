// What is said of an external mouse before it is started; on every system, since mice carry it along.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "labmouse/external/hidden_files.hpp"
#include "labmouse/external/limits.hpp"

namespace labmouse {

struct Surroundings;

/// How to start an external mouse.
struct Launch {
  /// The program and its arguments; a name without a slash is looked for in PATH.
  std::vector<std::string> words;
  /// What its environment has besides ours, or in place of it: NAME=VALUE.
  std::vector<std::string> environment;
  /// Where it runs; empty: here.
  std::string directory;
  /// Whether that directory is the mouse's own folder, too; otherwise it is the folder of the file that its words name.
  bool owns_directory = false;
  /// What is done before its greeting, where a bridge of ours greets and not its author: "the Robot of robot.py was
  /// made". Empty for all others.
  std::string beginning;
  ExternalLimits limits;
  /// Whether it lives in a sandbox (sandbox.hpp): it sees a copy of its folder, its interpreter and the system's
  /// programs, reaches no network and no process outside, and starts nowhere where why_no_sandbox() has something to
  /// say.
  bool sandbox = false;
  /// In a sandbox: it writes to its folder itself, and finds there what it wrote in earlier contests.
  bool keeps_folder = false;
  /// In a sandbox: files that it does not see, wherever they are; may be null.
  std::shared_ptr<const HiddenFiles> hidden;
  /// In a sandbox: what it sees, found out once for many starts; null: found out at each start.
  std::shared_ptr<const Surroundings> surroundings;
  /// Once true, waiting for an external mouse ends; may be null.
  const std::atomic<bool>* stop = nullptr;
};

}  // namespace labmouse
