// The page with a race in it: one HTML file to look at and to hand on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

/// What is wrong with a text as the page, or nothing: it must have one place for a report.
std::string wrong_page(std::string_view page);

/// The page with a report: two blocks of text, each by gzip and base64. `report` and `records` are JSON; see Report and
/// ReportRecords in apps/web/page/src/core/types.ts.
std::string with_report(std::string_view page, std::string_view report, std::string_view records);

/// A page, or why there is none: exactly one of the two is there.
struct ReportPage {
  std::string page;
  std::string error;
  /// What was left out and why, one line each.
  std::vector<std::string> notes;
};

/// The page (which must be one) with a race: `path` is the folder that a race left, or the JSON of a race. In it go the
/// results as they are; the records that lie in the folder or beside the JSON; and the mazes, of the records or as long
/// as they are found under their names.
ReportPage make_report(const std::string& path, std::string_view page);

}  // namespace labmouse
