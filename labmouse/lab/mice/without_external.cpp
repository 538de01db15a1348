// Stubs for builds without external mice (LABMOUSE_EXTERNAL=OFF, for systems other than Linux).
#include "labmouse/external/capstone.hpp"
#include "labmouse/external/command_line.hpp"
#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mice/external_specs.hpp"

namespace labmouse {

void read_external_spec(std::string_view, const ExternalOptions&, SpecResult& result) {
  result.error = "this build starts no programs; on Linux, build it with -DLABMOUSE_EXTERNAL=ON";
}

std::string program_path(std::string_view, std::string_view) { return ""; }

std::string python_version(const std::string&, bool) { return ""; }

std::string labmouse_version_in(const std::string&, const std::vector<std::string>&) { return ""; }

std::string python_packages(const std::string&, const std::vector<std::string>&, bool) { return ""; }

MmsRun run_mms(const Launch&, const Maze&, const MmsOptions&,
               const std::function<void(const MmsEvent&, const MmsHost&)>&) {
  MmsRun run;
  run.outcome = MmsOutcome::not_started;
  run.end = "this build starts no programs";
  return run;
}

}  // namespace labmouse
