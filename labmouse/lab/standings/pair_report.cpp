#include "labmouse/lab/standings/pair_report.hpp"

#include <fmt/format.h>

namespace labmouse {

std::string difference_heading() { return fmt::format(" {:>10} {:>18}  {}", "difference", "95 % interval", "verdict"); }

std::string difference_columns(const PairedDifference& found, TestVerdict verdict) {
  if (found.count == 0) return fmt::format(" {:>10} {:>18}", "-", "-");
  // + 0.0 turns -0.0 into 0.
  const std::string interval =
      found.count > 1 ? fmt::format("{:+.3f} to {:+.3f}", found.interval.low + 0.0, found.interval.high + 0.0) : "-";
  return fmt::format(" {:>+10.3f} {:>18}  {}", found.mean + 0.0, interval, name_of(verdict));
}

Json interval_json(const PairedDifference& found, double factor) {
  if (found.count < 2) return nullptr;
  const Interval ends = scaled(found.interval, factor);
  return {ends.low, ends.high};
}

Json difference_json(const PairedDifference& found, const PairVerdicts& verdicts) {
  return {{"mazes", found.count},
          {"mean_difference", found.count > 0 ? Json(found.mean) : Json(nullptr)},
          {"interval", interval_json(found)},
          {"p", verdicts.scores_p},
          {"verdict", name_of(verdicts.scores)},
          {"wins", found.below},
          {"ties", found.equal},
          {"losses", found.above},
          {"sign_test", found.sign_test}};
}

}  // namespace labmouse
