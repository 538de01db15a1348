#include <fmt/format.h>

#include "labmouse/lab/standings/pair_report.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/studies/ratios.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

Json folds_json(const Study& study) {
  std::size_t mazes = 0;
  for (const std::size_t size : study.fold_sizes) mazes += size;
  Json folds = Json::array();
  for (std::size_t fold = 0; fold < study.fold_sizes.size(); ++fold)
    folds.push_back({{"fold", fold + 1},
                     {"held_out", study.fold_sizes[fold]},
                     {"training", mazes - study.fold_sizes[fold]},
                     {"done", fold < static_cast<std::size_t>(study.folds_done)}});
  return folds;
}

Json ratios_json(const Study& study, const Comparison& comparison) {
  Json ratios = Json::array();
  for (const FigureRatio& ratio : ratios_of(study, comparison)) {
    const Interval& interval = ratio.found.interval;
    ratios.push_back({{"figure", ratio.figure},
                      {"mazes", ratio.mazes},
                      {"ratio", ratio.found.ratio},
                      {"interval", ratio.mazes > 1 ? Json{interval.low, interval.high} : Json(nullptr)}});
  }
  return ratios;
}

Json rates_json(const FinishRates& rates, const PairVerdicts& verdicts) {
  const PairedDifference& finished = rates.finished_only;
  return {{"finish_rates",
           {{"finished", {rates.mouse.finished, rates.against.finished}},
            {"contests", {rates.mouse.contests, rates.against.contests}},
            {"mean_difference", rates.failed.count > 0 ? Json(-rates.failed.mean) : Json(nullptr)},
            {"interval", interval_json(rates.failed, -1.0)},
            {"p", verdicts.rates_p},
            {"verdict", name_of(verdicts.rates)}}},
          {"finished_only",
           {{"mazes", finished.count},
            {"mean_difference", finished.count > 0 ? Json(finished.mean) : Json(nullptr)},
            {"interval", interval_json(finished)}}}};
}

Json comparison_json(const Study& study, const Comparison& comparison) {
  Json json = {{"mouse", study.race.mice[comparison.mouse].name},
               {"against", study.race.mice[comparison.against].name}};
  json.update(difference_json(comparison.pair.scores, comparison.verdicts));
  json["ratios"] = ratios_json(study, comparison);
  if (comparison.pair.has_rates) json.update(rates_json(comparison.pair.rates, comparison.verdicts));
  return json;
}

}  // namespace

std::string json_of(const Study& study, const std::vector<SkippedFile>& skipped) {
  Json json = race_json({&study.race, 1}, skipped);
  Json& mazes = json["groups"][0]["mazes"];
  for (std::size_t maze = 0; maze < study.fold_of.size(); ++maze) mazes[maze]["fold"] = study.fold_of[maze] + 1;
  json["folds"] = folds_json(study);
  json["learning"] = study.order.learning;
  json["learners"] = study.learners;
  json["comparisons"] = Json::array();
  for (const Comparison& comparison : comparisons_of(study))
    json["comparisons"].push_back(comparison_json(study, comparison));
  json["duplicates"] = Json::array();
  for (const Duplicate& duplicate : study.selection.duplicates)
    json["duplicates"].push_back({{"name", duplicate.name}, {"same_as", duplicate.same_as}});
  json["routeless"] = study.selection.routeless;
  return text_of(json);
}

std::string csv_of(const Study& study) {
  std::vector<std::vector<std::optional<double>>> scores;
  std::string text = "maze,fold,bound";
  for (const std::string& mouse : study.mice) {
    text += "," + csv_field(mouse);
    scores.push_back(scores_by_maze(study.race, position_of(study.race, mouse)));
  }
  text += "\n";
  for (std::size_t maze = 0; maze < study.race.mazes.size(); ++maze) {
    text += fmt::format("{},{},{}", csv_field(study.race.mazes[maze].name), study.fold_of[maze] + 1,
                        *study.race.facts[maze].bound);
    for (const auto& of_mouse : scores) text += "," + (of_mouse[maze] ? fmt::format("{}", *of_mouse[maze]) : "");
    text += "\n";
  }
  return text;
}

}  // namespace labmouse
