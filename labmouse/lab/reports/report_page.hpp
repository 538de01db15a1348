// The page with the results of a race inside: one HTML file to view and to share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/reports/report_records.hpp"
#include "labmouse/lab/reports/report_results.hpp"

namespace labmouse {

/// What is wrong with the text of a page, or nothing. A page must have exactly one place for a report.
std::string wrong_page(std::string_view page);

/// The page with a report inserted as two text blocks, both compressed with gzip and encoded in base64. `report` and
/// `records` are JSON; see Report and ReportRecords in apps/web/page/src/core/types.ts.
std::string with_report(std::string_view page, std::string_view report, std::string_view records);

/// A page, or why there is none: exactly one of the two is there.
struct ReportPage {
  std::string page;
  std::string error;
  /// What was left out and why, one line each.
  std::vector<std::string> notes;
};

/// Makes a page from a race. `page` must pass wrong_page(); `path` is the folder of a race or its JSON file. The page
/// gets the results, the records in that folder or beside the file, and the mazes: those of the records, else those
/// found by name.
ReportPage make_report(const std::string& path, std::string_view page);

/// The same of results and records that were read.
ReportPage make_report(const ReportResults& results, ReportRecords records, std::string_view page);

}  // namespace labmouse
