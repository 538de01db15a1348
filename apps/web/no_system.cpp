// Replaces functions that need an operating system: in the page there are no files, no programs and no threads.
#include "labmouse/external/hidden_files.hpp"
#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mice/external_specs.hpp"
#include "labmouse/lab/mice/mice_file_specs.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/lab/system/version.hpp"

namespace labmouse {

FileContent read_file(const std::string&, std::size_t) { return {"", "a page reads no files"}; }

FileContent read_found_file(const std::string&, std::size_t) { return {"", "a page reads no files"}; }

void HiddenFiles::add(const std::string&) {}
void HiddenFiles::add_if_there(const std::string&) {}

void HiddenFiles::add_store(const std::string&) {}

void read_external_spec(std::string_view, const ExternalOptions&, SpecResult& result) {
  result.error = "a page starts no programs";
}

void read_mice_file_spec(std::string_view, const ExternalOptions&, const Setting*, ReadOwnMouse, SpecResult& result) {
  result.error = "a page reads no files";
}

MmsRun run_mms(const Launch&, const Maze&, const MmsOptions&,
               const std::function<void(const MmsEvent&, const MmsHost&)>&) {
  MmsRun run;
  run.outcome = MmsOutcome::not_started;
  run.end = "a page starts no programs";
  return run;
}

std::string processor() { return "WebAssembly"; }

void for_each_parallel(std::size_t count, int, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

}  // namespace labmouse
