// What is said of a guest before it is started; on every system, since mice carry it along.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "labmouse/guests/limits.hpp"

namespace labmouse {

/// How to start a guest.
struct Launch {
  /// The program and its arguments; a name without a slash is looked for in PATH.
  std::vector<std::string> words;
  /// What its environment has besides ours, or in place of it: NAME=VALUE.
  std::vector<std::string> environment;
  /// Where it runs; empty: here.
  std::string directory;
  /// What is done before its greeting, where a bridge of ours greets and not its author: "the Robot of robot.py was
  /// made". Empty for all others.
  std::string beginning;
  GuestLimits limits;
  /// Whether it lives in a sandbox (sandbox.hpp): it writes only to its folder and to a /tmp of its own, reaches no
  /// network and no process outside, and starts nowhere where why_no_sandbox() has something to say.
  bool sandbox = false;
  /// Once true, waiting for a guest ends; may be null.
  const std::atomic<bool>* stop = nullptr;
};

}  // namespace labmouse
