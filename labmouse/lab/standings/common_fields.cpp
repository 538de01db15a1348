#include "labmouse/lab/standings/common_fields.hpp"

#include <fmt/format.h>

#include <cmath>

#include "labmouse/lab/records/settings_json.hpp"

namespace labmouse::fields {

Value mouse_name(const Race& race, const ContestResult& contest) { return race.mice[contest.mouse].name; }
Value maze_name(const Race& race, const ContestResult& contest) { return race.mazes[contest.maze].name; }
Value seed(const Race&, const ContestResult& contest) { return static_cast<std::int64_t>(contest.seed); }
Value outcome(const Race&, const ContestResult& contest) { return contest.outcome; }
Value score(const Race&, const ContestResult& contest) { return value_of(contest.score); }
Value ratio(const Race&, const ContestResult& contest) { return value_of(contest.ratio); }

Value name(const Race& race, const Standing& standing) { return race.mice[standing.mouse].name; }
Value parameters(const Race& race, const Standing& standing) {
  return JsonText{settings_json(race.world().settings(race.mice[standing.mouse])).dump()};
}
Value contestant(const Race& race, const Standing& standing) { return !race.mice[standing.mouse].reference; }
Value finished(const Race&, const Standing& standing) { return std::int64_t{standing.finished}; }
Value runs(const Race&, const Standing& standing) { return std::int64_t{standing.runs}; }
Value mean_all(const Race&, const Standing& standing) { return value_of(standing.mean_all); }
Value mean_finished(const Race&, const Standing& standing) { return value_of(standing.mean_finished); }
Value interval(const Race&, const Standing& standing) {
  if (!standing.mean_all) return nullptr;
  return JsonText{ReadJson{standing.interval.low, standing.interval.high}.dump()};
}
Value mean_ratio(const Race&, const Standing& standing) { return value_of(standing.mean_ratio); }
Value mean_share(const Race&, const Standing& standing) { return value_of(standing.mean_share); }
Value share_interval(const Race&, const Standing& standing) {
  if (!standing.mean_share) return nullptr;
  return JsonText{ReadJson{standing.share.low, standing.share.high}.dump()};
}

Value name(const Race& race, std::size_t maze) { return race.mazes[maze].name; }
Value width(const Race& race, std::size_t maze) { return std::int64_t{race.mazes[maze].maze.size().width}; }
Value height(const Race& race, std::size_t maze) { return std::int64_t{race.mazes[maze].maze.size().height}; }
Value bound(const Race& race, std::size_t maze) { return value_of(race.facts[maze].bound); }
Value best_run(const Race& race, std::size_t maze) { return value_of(race.facts[maze].best_run); }
Value whole_best_run(const Race& race, std::size_t maze) {
  const auto& best = race.facts[maze].best_run;
  return best ? Value(std::llround(*best)) : Value(nullptr);
}

}  // namespace labmouse::fields

namespace labmouse::columns {

std::string heading(std::string_view first, std::string_view second) {
  return fmt::format("{}{}{}", first, first.empty() || second.empty() ? "" : " ", second);
}

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string finished(const Race&, const Standing& standing) {
  return fmt::format("{}/{}", standing.finished, standing.runs);
}
std::string mean_all(const Race&, const Standing& standing) { return number(standing.mean_all, 3); }
std::string mean_finished(const Race&, const Standing& standing) { return number(standing.mean_finished, 3); }
std::string mean_ratio(const Race&, const Standing& standing) { return number(standing.mean_ratio, 3); }
std::string mean_share(const Race&, const Standing& standing) {
  return standing.mean_share ? fmt::format("{:.1f}", 100.0 * *standing.mean_share) : "-";
}
std::string share_interval(const Race&, const Standing& standing) {
  if (!standing.mean_share || standing.mazes < 2) return "-";
  return fmt::format("{:.1f}-{:.1f}", 100.0 * standing.share.low, 100.0 * standing.share.high);
}

std::string interval(const Standing& standing, int digits) {
  const Interval& found = standing.interval;
  if (!standing.mean_all || standing.mazes < 2) return "-";
  return fmt::format("{:.{}f}{}{:.{}f}", found.low, digits, found.low < 0 || found.high < 0 ? " to " : "-", found.high,
                     digits);
}

}  // namespace labmouse::columns
