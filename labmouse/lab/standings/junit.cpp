#include "labmouse/lab/standings/junit.hpp"

#include <fmt/format.h>

#include "labmouse/lab/standings/race_names.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The tests of a mouse, and how many of them there are of each kind.
struct Suite {
  std::string cases;
  int tests = 0, failures = 0, skipped = 0;

  /// Adds a test; `inside` is an element that says how it ended, empty for a passed one.
  void add(const std::string& suite, const std::string& name, const std::string& inside) {
    ++tests;
    cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml_escaped(suite), xml_escaped(name));
    cases += inside.empty() ? "/>\n" : fmt::format(">{}</testcase>\n", inside);
  }

  void fail(const std::string& suite, const std::string& name, const std::string& message) {
    ++failures;
    add(suite, name, fmt::format("<failure message=\"{}\"/>", xml_escaped(message)));
  }
};

Suite suite_of(const Race& race, const Standing& standing, const std::string& name, std::optional<double> limit) {
  Suite suite;
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != standing.mouse || !contest.done) continue;
    const std::string test = fmt::format("{}, run {}", race.mazes[contest.maze].name, contest.run + 1);
    if (!counts(race, contest)) {
      ++suite.skipped;
      suite.add(name, test, "<skipped/>");
    } else if (contest.score) {
      suite.add(name, test, "");
    } else {
      suite.fail(name, test, contest.outcome);
    }
  }
  if (!limit || !standing.mean_at_limit) return suite;
  const std::string test = "mean score";
  if (*standing.mean_at_limit > *limit)
    suite.fail(name, test, fmt::format("{:.3f} is above the limit of {:g}", *standing.mean_at_limit, *limit));
  else
    suite.add(name, test, "");
  return suite;
}

}  // namespace

std::string junit_of(std::span<const Race> races, std::optional<double> limit) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"labmouse\">\n";
  const std::vector<std::string> names = race_names(races);
  for (std::size_t i = 0; i < races.size(); ++i) {
    const Race& race = races[i];
    for (const Standing& standing : standings_of(race)) {
      if (race.mice[standing.mouse].reference) continue;
      const std::string name = fmt::format("{} ({})", race.mice[standing.mouse].name, names[i]);
      const Suite suite = suite_of(race, standing, name, limit);
      text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n{}  </testsuite>\n",
                          xml_escaped(name), suite.tests, suite.failures, suite.skipped, suite.cases);
    }
  }
  return text + "</testsuites>\n";
}

}  // namespace labmouse
