#include "labmouse/lab/races/never_started.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

bool never_began(const ContestResult& result) { return !result.started; }

bool never_began(const MmsResult& result) {
  return result.run.outcome != MmsOutcome::complete && result.run.outcome != MmsOutcome::interrupted &&
         result.run.lines == 0;
}

std::string why(const ContestResult& result) { return result.last_words.substr(0, result.last_words.find('\n')); }

std::string why(const MmsResult& result) {
  return result.run.end.empty() ? std::string(name_of(result.run.outcome)) : result.run.end;
}

template <class AnyRace>
std::string lines_of(const AnyRace& race) {
  std::string lines;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    const auto held = [&](const auto& result) { return result.mouse == mouse && result.done; };
    const auto raced = [&](const auto& result) { return held(result) && !never_began(result); };
    const auto first = std::find_if(race.results.begin(), race.results.end(), held);
    if (first == race.results.end() || std::any_of(race.results.begin(), race.results.end(), raced)) continue;
    lines += shown(fmt::format("{} failed to start in every contest: {}", race.mice[mouse].name, why(*first))) + "\n";
  }
  return lines;
}

}  // namespace

std::string never_started_lines(const Race& race) { return lines_of(race); }

std::string never_started_lines(const MmsRace& race) { return lines_of(race); }

}  // namespace labmouse
