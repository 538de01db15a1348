#include <fstream>

#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
      return shown(line.substr(colon + 2));
  return "unknown";
}

}  // namespace labmouse
