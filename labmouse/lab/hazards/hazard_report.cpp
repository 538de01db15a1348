#include <fmt/format.h>

#include "labmouse/lab/hazards/hazards.hpp"
#include "labmouse/lab/numbers/wilson.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

Interval interval_of(std::int64_t part, std::int64_t all) {
  return wilson_interval(static_cast<int>(part), static_cast<int>(all));
}

/// "4-8 %", or what is below the first limit or above the last.
std::string name_of_level(std::size_t level) {
  const auto percent = [](double limit) { return fmt::format("{:g}", 100.0 * limit); };
  if (level == 0) return "below " + percent(astray_limits.front());
  if (level == astray_limits.size()) return percent(astray_limits.back()) + " and more";
  return percent(astray_limits[level - 1]) + " to " + percent(astray_limits[level]);
}

/// A thousandth part, with its interval; a dash where nothing was counted.
std::string per_thousand(std::int64_t part, std::int64_t all) {
  if (all == 0) return fmt::format("{:>9} {:>15}", "-", "-");
  const Interval interval = interval_of(part, all);
  return fmt::format("{:>9.3f} {:>15}", 1000.0 * share_of(part, all),
                     fmt::format("{:.3f}-{:.3f}", 1000.0 * interval.low, 1000.0 * interval.high));
}

/// How many of those without a crash ended within 8 % of a cell, in percent.
std::string near(const ManoeuvreCount& count) {
  const std::int64_t ended = count.times - count.crashes;
  if (ended == 0) return "-";
  return fmt::format("{:.2f}", 100.0 * share_of(count.after[0] + count.after[1] + count.after[2], ended));
}

std::string line_of(std::string_view name, const ManoeuvreCount& count) {
  return fmt::format("{:<14} {:>9} {:>8} {} {:>8}\n", name, count.times, count.crashes,
                     per_thousand(count.crashes, count.times), near(count));
}

std::string line_of(std::string_view name, const ReadingCount& beside, const ReadingCount& ahead) {
  return fmt::format("{:<14} {:>9} {} {:>9} {}\n", name, beside.times, per_thousand(beside.wrong, beside.times),
                     ahead.times, per_thousand(ahead.wrong, ahead.times));
}

std::string table_of(const HazardTally& tally) {
  const Interval finished = interval_of(tally.finished, tally.contests);
  std::string text =
      fmt::format("Noise {:g}: {} contests, {:.1f} % finished ({:.1f}-{:.1f})\n", tally.noise, tally.contests,
                  100.0 * share_of(tally.finished, tally.contests), 100.0 * finished.low, 100.0 * finished.high);
  const auto heading = [](std::string_view first) {
    return fmt::format("{:<14} {:>9} {:>8} {:>9} {:>15} {:>8}\n", first, "times", "crashes", "of 1000", "95 %",
                       "near %");
  };
  text += "\n" + heading("manoeuvre");
  for (const Manoeuvre manoeuvre : all_manoeuvres) text += line_of(name_of(manoeuvre), tally.of(manoeuvre));
  text += "\n" + heading("astray, %");
  for (std::size_t level = 0; level < astray_levels; ++level) text += line_of(name_of_level(level), tally.at(level));
  text += fmt::format("\n{:<14} {:>9} {:>9} {:>15} {:>9} {:>9} {:>15}\n", "readings", "beside", "wrong of", "95 %",
                      "ahead", "wrong of", "95 %");
  text += fmt::format("{:<14} {:>9} {:>9} {:>15} {:>9} {:>9}\n", "astray, %", "", "1000", "", "", "1000");
  for (std::size_t level = 0; level < astray_levels; ++level) {
    const auto both = [&](Reading wall, Reading gap) {
      ReadingCount sum = tally.readings[static_cast<std::size_t>(wall)][level];
      sum += tally.readings[static_cast<std::size_t>(gap)][level];
      return sum;
    };
    text += line_of(name_of_level(level), both(Reading::wall_beside, Reading::gap_beside),
                    both(Reading::wall_ahead, Reading::gap_ahead));
  }
  return text;
}

Json json_of(const ManoeuvreCount& count) {
  const Interval interval = interval_of(count.crashes, count.times);
  return {{"times", count.times},
          {"crashes", count.crashes},
          {"crash_interval", {interval.low, interval.high}},
          {"after", count.after}};
}

Json json_of(const ReadingCount& count) {
  const Interval interval = interval_of(count.wrong, count.times);
  return {{"times", count.times},
          {"wrong", count.wrong},
          {"silent", count.silent},
          {"wrong_interval", {interval.low, interval.high}}};
}

Json json_of(const HazardTally& tally) {
  Json json = {{"noise", tally.noise}, {"contests", tally.contests}, {"finished", tally.finished}};
  for (const Manoeuvre manoeuvre : all_manoeuvres)
    for (const ManoeuvreCount& count : tally.manoeuvres[static_cast<std::size_t>(manoeuvre)])
      json["manoeuvres"][std::string(name_of(manoeuvre))].push_back(json_of(count));
  for (const Reading reading : all_readings)
    for (const ReadingCount& count : tally.readings[static_cast<std::size_t>(reading)])
      json["readings"][std::string(name_of(reading))].push_back(json_of(count));
  return json;
}

}  // namespace

std::string table_of(std::span<const HazardTally> tallies) {
  std::string text;
  for (const HazardTally& tally : tallies) text += (text.empty() ? "" : "\n") + table_of(tally);
  return text;
}

std::string json_of(std::span<const HazardTally> tallies, const HazardOrder& order, std::span<const Contestant> mice) {
  Json json = {{"robot", order.model->robot.name},
               {"rules", order.rules.name},
               {"spread", order.conditions.noise.spread},
               {"search_speed", order.conditions.pilot.search_speed},
               {"map", std::string(name_of(order.conditions.map))},
               {"seed", order.seed},
               {"runs", order.runs},
               {"astray_limits", astray_limits}};
  for (const Contestant& mouse : mice) json["mice"].push_back(mouse.name);
  for (const HazardTally& tally : tallies) json["noises"].push_back(json_of(tally));
  return json.dump() + "\n";
}

}  // namespace labmouse
