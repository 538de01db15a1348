#include "report.hpp"

#include <fmt/format.h>

#include <atomic>
#include <filesystem>

#include "embedded_page.hpp"
#include "errors.hpp"
#include "labmouse/lab/reports/report_page.hpp"
#include "labmouse/lab/result_folders/race_folder.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/calls.hpp"
#include "labmouse/lab/system/files.hpp"

namespace fs = std::filesystem;

namespace labmouse::python {
namespace {

/// A new temporary folder, removed by the destructor.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static std::atomic<unsigned> folders{0};
    std::error_code error;
    const fs::path place = fs::temp_directory_path(error);
    // The name may be taken: an earlier process with the same id may have been killed before it removed its folder.
    do path_ = (place / fmt::format("labmouse-{}-{}", process_number(), folders++)).string();
    while (!error && !fs::create_directory(path_, error));
    if (!error) fs::permissions(path_, fs::perms::owner_all, error);
    if (error) throw UserError("no temporary folder can be made: " + error.message());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code unknown;
    fs::remove_all(path_, unknown);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

std::string report_of(const Race& race, const std::vector<std::pair<ContestResult, ContestOutput>>& contests) {
  const std::string_view page = cli::embedded_page();
  if (page.empty())
    throw UserError("this package was built without the page; run `make page` and build the package again");
  const TemporaryFolder folder;
  const RaceFolder files(folder.path(), race);
  for (const auto& [contest, held] : contests) {
    ContestOutput record;
    record.record = held.record;
    if (const auto error = files.save(contest, record); !error.empty()) throw UserError(error);
  }
  const std::string results = fmt::format("{}/{}", folder.path(), results_file_name);
  if (const auto error = write_file(results, json_of(race, {})); !error.empty()) throw UserError(error);
  ReportPage report = make_report(folder.path(), page);
  if (!report.error.empty()) throw UserError(report.error);
  return std::move(report.page);
}

}  // namespace labmouse::python
