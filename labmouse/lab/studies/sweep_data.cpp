#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/standings/pair_report.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/lab/system/version.hpp"

namespace labmouse {
namespace {

Json number_json(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

std::string field(const std::optional<double>& number) { return number ? fmt::format("{}", *number) : ""; }

/// The verdict of each point, in the order of the points; the first one's is without meaning.
std::vector<PairVerdicts> verdicts_of_points(const Sweep& sweep) {
  std::vector<MousePair> pairs;
  for (const SweepPoint& point : sweep.points)
    if (point.against_first) pairs.push_back(*point.against_first);
  std::vector<PairVerdicts> verdicts = verdicts_of(pairs);
  verdicts.insert(verdicts.begin(), sweep.points.size() - pairs.size(), PairVerdicts());
  return verdicts;
}

Json point_json(const Sweep& sweep, const SweepPoint& point, const PairVerdicts& verdicts) {
  Json json = {{"value", point.value},
               {"mean", number_json(point.mean)},
               {"interval", point.interval ? Json{point.interval->low, point.interval->high} : Json(nullptr)},
               {"failed", point.failures},
               {"contests", point.runs},
               {"finished_mean", number_json(point.finished_mean)}};
  if (!sweep.robot.empty())
    json["difference"] = point.against_first ? difference_json(point.against_first->scores, verdicts) : Json(nullptr);
  return json;
}

/// The difference of a point in CSV: mean, both ends of the interval and verdict.
std::string difference_fields(const SweepPoint& point, const PairVerdicts& verdicts) {
  if (!point.against_first) return ",,,,";
  const PairedDifference& found = point.against_first->scores;
  if (found.count < 2)
    return fmt::format(",{},,,{}", found.count > 0 ? field(found.mean) : "", name_of(verdicts.scores));
  return fmt::format(",{},{},{},{}", found.mean, found.interval.low, found.interval.high, name_of(verdicts.scores));
}

}  // namespace

std::string json_of(const Sweep& sweep) {
  const World& world = *sweep.order.world;
  Json json = {{"labmouse", version()}, {"mouse", sweep.mouse}};
  if (!sweep.robot.empty()) json["robot"] = sweep.robot;
  json.update(Json{{"parameter", sweep.parameter},
                   {"meaning", sweep.meaning},
                   {"world", world.traits().name},
                   {"conditions", conditions_json(world)},
                   {"unit", world.traits().unit},
                   {"limit_score", world.traits().limit_score},
                   {"seed", sweep.order.seed},
                   {"mazes", sweep.mazes},
                   {"routeless", sweep.routeless},
                   {"stopped", sweep.points.size() < sweep.values},
                   {"values", Json::array()}});
  const std::vector<PairVerdicts> verdicts = verdicts_of_points(sweep);
  for (std::size_t i = 0; i < sweep.points.size(); ++i)
    json["values"].push_back(point_json(sweep, sweep.points[i], verdicts[i]));
  return text_of(json);
}

std::string csv_of(const Sweep& sweep) {
  const bool finished = !sweep.order.world->traits().failure_score, robots = !sweep.robot.empty();
  std::string text = fmt::format("value,mean,low,high,failures,runs{}{}\n", finished ? ",finished_mean" : "",
                                 robots ? ",difference,difference_low,difference_high,verdict" : "");
  const std::vector<PairVerdicts> verdicts = verdicts_of_points(sweep);
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    const SweepPoint& point = sweep.points[i];
    const std::string ends = point.interval ? fmt::format("{},{}", point.interval->low, point.interval->high) : ",";
    text += fmt::format("{},{},{},{},{}", point.value, field(point.mean), ends, point.failures, point.runs);
    if (finished) text += "," + field(point.finished_mean);
    if (robots) text += difference_fields(point, verdicts[i]);
    text += "\n";
  }
  return text;
}

}  // namespace labmouse
