// Interpreters that a machine may have or lack.
#pragma once

#include <cstdlib>
#include <initializer_list>
#include <string>

namespace labmouse::test {

/// The first of the commands that runs with that argument and ends with exit code 0; empty where none does. A name in
/// PATH is not enough: version managers leave names there that only say what is missing.
inline std::string first_that_runs(std::initializer_list<const char*> names, const std::string& argument) {
  for (const std::string name : names)
    if (std::system(("'" + name + "' " + argument + " >/dev/null 2>&1 </dev/null").c_str()) == 0) return name;
  return "";
}

inline const std::string& python3() {
  static const std::string name = first_that_runs({"python3"}, "-c 'import sys; sys.exit(sys.version_info[0] != 3)'");
  return name;
}

inline const std::string& python2() {
  static const std::string name =
      first_that_runs({"python2.7", "python2"}, "-c 'import sys; sys.exit(sys.version_info[:2] != (2, 7))'");
  return name;
}

/// The one that `scripts/install ci` makes, or that of PATH.
inline const std::string& python_with_numpy() {
  static const std::string name =
      first_that_runs({LABMOUSE_SOURCE_DIR "/build/python/bin/python", "python3"}, "-c 'import numpy'");
  return name;
}

inline const std::string& node() {
  static const std::string name = first_that_runs({"node", "nodejs"}, "--version");
  return name;
}

}  // namespace labmouse::test
