#include "labmouse/lab/standings/junit.hpp"

#include <fmt/format.h>

#include "labmouse/lab/standings/junit_suite.hpp"
#include "labmouse/lab/standings/race_names.hpp"
#include "labmouse/lab/standings/standings.hpp"

namespace labmouse {
namespace {

JUnitSuite suite_of(const Race& race, const Standing& standing, const std::string& name, std::optional<double> limit) {
  JUnitSuite suite(name);
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != standing.mouse || !contest.done) continue;
    const std::string test = fmt::format("{}, run {}", race.mazes[contest.maze].name, contest.run + 1);
    if (!counts(race, contest))
      suite.skip(test);
    else if (contest.score)
      suite.pass(test);
    else
      suite.fail(test, contest.outcome);
  }
  if (!limit || !standing.mean_at_limit) return suite;
  const std::string test = "mean score";
  if (*standing.mean_at_limit > *limit)
    suite.fail(test, fmt::format("{:.3f} is above the limit of {:g}", *standing.mean_at_limit, *limit));
  else
    suite.pass(test);
  return suite;
}

}  // namespace

std::string junit_of(std::span<const Race> races, std::optional<double> limit) {
  std::vector<JUnitSuite> suites;
  const std::vector<std::string> names = race_names(races);
  for (std::size_t i = 0; i < races.size(); ++i)
    for (const Standing& standing : standings_of(races[i])) {
      const Contestant& mouse = races[i].mice[standing.mouse];
      if (mouse.reference) continue;
      suites.push_back(suite_of(races[i], standing, fmt::format("{} ({})", mouse.name, names[i]), limit));
    }
  return junit_text(suites);
}

}  // namespace labmouse
