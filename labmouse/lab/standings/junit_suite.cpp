#include "labmouse/lab/standings/junit_suite.hpp"

#include <fmt/format.h>

#include "labmouse/lab/text/printable.hpp"

namespace labmouse {

void JUnitSuite::add(const std::string& test, const std::string& inside) {
  ++tests_;
  cases_ += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml_escaped(name_), xml_escaped(test));
  cases_ += inside.empty() ? "/>\n" : fmt::format(">{}</testcase>\n", inside);
}

void JUnitSuite::skip(const std::string& test) {
  ++skipped_;
  add(test, "<skipped/>");
}

void JUnitSuite::fail(const std::string& test, const std::string& message) {
  ++failures_;
  add(test, fmt::format("<failure message=\"{}\"/>", xml_escaped(message)));
}

std::string JUnitSuite::text() const {
  return fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n{}  </testsuite>\n",
                     xml_escaped(name_), tests_, failures_, skipped_, cases_);
}

std::string junit_text(std::span<const JUnitSuite> suites) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"labmouse\">\n";
  for (const JUnitSuite& suite : suites) text += suite.text();
  return text + "</testsuites>\n";
}

}  // namespace labmouse
