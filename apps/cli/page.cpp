// labmouse page: writes the page for a browser. labmouse report: writes that page with a race in it.
#include "page.hpp"

#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "embedded_page.hpp"
#include "labmouse/lab/reports/report_page.hpp"
#include "labmouse/lab/system/files.hpp"

namespace labmouse::cli {
namespace {

struct PageOptions {
  std::string results, page, out;
};

/// Prints the first notes and counts the others.
void tell_notes(const std::vector<std::string>& notes) {
  constexpr std::size_t told = 10;
  for (std::size_t i = 0; i < notes.size() && i < told; ++i) tell(notes[i] + "\n");
  if (notes.size() > told) tell(fmt::format("... and {} more\n", notes.size() - told));
}

void report(const PageOptions& options) {
  const std::string page = find_page(options.page);
  expect_outputs({{"--page", options.page}, {"--out", options.out, FileKind::page}});
  const ReportPage report = make_report(options.results, page);
  if (!report.error.empty()) throw UsageError(report.error);
  tell_notes(report.notes);
  save(options.out, report.page);
}

void add_page_options(Command& command, PageOptions& options) {
  command.add_option("-o,--out", options.out, "File to write; - is standard output")->required()->type_name("FILE");
  command.add_option("--page", options.page, "Use this page instead of the built-in one")->type_name("FILE");
}

}  // namespace

std::string find_page(const std::string& path) {
  if (path.empty() && embedded_page().empty())
    throw UsageError(
        "error: this program was built without the page; run `make page` and build the program again, or name a page "
        "with --page FILE");
  if (path.empty()) return std::string(embedded_page());
  FileContent file = read_file(path, std::size_t{1} << 26U);
  if (file.error.empty()) file.error = wrong_page(file.content);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", path, file.error));
  return std::move(file.content);
}

void add_page(Command& app, int& exit) {
  auto options = std::make_shared<PageOptions>();
  Command* command = app.add_subcommand("page", "Write the page for a browser: replays, comparisons and a maze editor");
  add_page_options(*command, *options);
  command->footer("Example: labmouse page -o labmouse.html");
  command->callback([options, &exit] {
    const std::string page = find_page(options->page);
    expect_outputs({{"--page", options->page}, {"--out", options->out, FileKind::page}});
    save(options->out, page);
    exit = exit_good;
  });
}

void add_report(Command& app, int& exit) {
  auto options = std::make_shared<PageOptions>();
  Command* command = app.add_subcommand("report", "Write the page with a race inside: results, mazes and records");
  command
      ->add_option("results", options->results,
                   "Folder of `labmouse race --out`, or a JSON file of `labmouse race --format json`")
      ->required()
      ->type_name("RESULTS");
  add_page_options(*command, *options);
  command->footer("Example: labmouse race --mice flood,certify --out race && labmouse report race -o report.html");
  command->callback([options, &exit] {
    report(*options);
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
