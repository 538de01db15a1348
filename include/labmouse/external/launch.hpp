// Options for the start of an external mouse; available on every system.
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
  /// The program and its arguments. A name without a slash is searched in PATH; another one is relative to `directory`.
  std::vector<std::string> words;
  /// Variables NAME=VALUE, added to the inherited environment or replacing parts of it.
  std::vector<std::string> environment;
  /// Its working directory; empty: the current one.
  std::string directory;
  /// Whether that directory is also the mouse's own folder; otherwise the own folder is that of the file named by its
  /// words.
  bool owns_directory = false;
  /// For mice with a bridge: what happens before the greeting, for messages, such as "the Robot of robot.py was made".
  /// Empty for others.
  std::string beginning;
  ExternalLimits limits;
  /// Whether it runs in a sandbox (sandbox.hpp). There it sees a copy of its folder, its interpreter and the system's
  /// programs, and no network and no outside process. It is not started if why_no_sandbox() is not empty.
  bool sandbox = false;
  /// In a sandbox: it writes to its real folder, so that files stay for later contests.
  bool keeps_folder = false;
  /// In a sandbox: files hidden from it; may be null.
  std::shared_ptr<const HiddenFiles> hidden;
  /// In a sandbox: what it sees, computed once for many starts; null: computed at each start.
  std::shared_ptr<const Surroundings> surroundings;
  /// When it becomes true, each wait for the mouse ends; may be null.
  const std::atomic<bool>* stop = nullptr;
};

}  // namespace labmouse
