#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/failure_rates/counts_by_maze.hpp"
#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/failure_rates/failure_rates.hpp"
#include "labmouse/lab/numbers/wilson.hpp"
#include "labmouse/lab/text/errors_text.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// "4 to 8", in percent, or what is below the first limit or above the last.
template <std::size_t Size>
std::string name_of_class(std::size_t place, const std::array<double, Size>& limits) {
  const auto percent = [](double limit) { return fmt::format("{:g}", 100.0 * limit); };
  if (place == 0) return "below " + percent(limits.front());
  if (place == limits.size()) return percent(limits.back()) + " and more";
  return percent(limits[place - 1]) + " to " + percent(limits[place]);
}

std::string name_of_level(std::size_t level) { return name_of_class(level, position_error_limits); }

/// A share per thousand, with its interval; dashes if nothing was counted.
template <class ShareOf>
std::string per_thousand(const CountsByMaze& counts, ShareOf share) {
  const Share of = share(counts.all);
  if (of.all == 0) return fmt::format("{:>9} {:>15}", "-", "-");
  const Interval interval = counts.interval(share);
  return fmt::format("{:>9.3f} {:>15}", 1000.0 * share_of(of.part, of.all),
                     fmt::format("{:.3f}-{:.3f}", 1000.0 * interval.low, 1000.0 * interval.high));
}

/// How many of those without a crash ended within 8 % of a cell, in percent.
std::string near(const ManoeuvreCount& count) {
  const std::int64_t ended = count.times - count.crashes;
  if (ended == 0) return "-";
  return fmt::format("{:.2f}", 100.0 * share_of(count.after[0] + count.after[1] + count.after[2], ended));
}

/// The line of a table for the manoeuvres that `select` takes from counts.
template <class Select>
std::string manoeuvre_line(std::string_view name, const CountsByMaze& counts, Select select) {
  const ManoeuvreCount count = select(counts.all);
  const auto crashes = [&](const FailureCounts& some) {
    const ManoeuvreCount of = select(some);
    return Share{of.crashes, of.times};
  };
  return fmt::format("{:<14} {:>9} {:>8} {} {:>8}\n", name, count.times, count.crashes, per_thousand(counts, crashes),
                     near(count));
}

/// Wrong readings of walls and gaps, of all.
Share wrong_walls_of(const FailureCounts& counts, std::initializer_list<Reading> readings, std::size_t level) {
  Share sum;
  for (const Reading reading : readings) {
    const ReadingCount& count = counts.readings[static_cast<std::size_t>(reading)][level];
    sum.all += count.times();
    sum.part += count.wrong(reading);
  }
  return sum;
}

std::string readings_line(const CountsByMaze& counts, std::size_t level) {
  using enum Reading;
  const auto beside = [&](const FailureCounts& some) {
    return wrong_walls_of(some, {wall_beside, gap_beside, wall_beside_again, gap_beside_again}, level);
  };
  const auto ahead = [&](const FailureCounts& some) {
    return wrong_walls_of(some, {wall_ahead, gap_ahead, wall_ahead_again, gap_ahead_again}, level);
  };
  return fmt::format("{:<14} {:>9} {} {:>9} {}\n", name_of_level(level), beside(counts.all).all,
                     per_thousand(counts, beside), ahead(counts.all).all, per_thousand(counts, ahead));
}

Share finished_share(const FailureCounts& counts) { return {counts.finished, counts.contests}; }

/// "522 contests, 81.2 % finished (79.0-83.1)"
std::string finished_text_of(const CountsByMaze& by_maze) {
  const FailureCounts& counts = by_maze.all;
  const Interval finished = by_maze.interval(finished_share);
  return fmt::format("{} contests, {:.1f} % finished ({:.1f}-{:.1f})", counts.contests,
                     100.0 * share_of(counts.finished, counts.contests), 100.0 * finished.low, 100.0 * finished.high);
}

std::string table_of(const MeasuredRates& measured, const FailureOrder& order, std::size_t place) {
  const FailureTally& tally = measured.tallies[place];
  const CountsByMaze counts = counts_of(measured, place, [](const FailureTally& each) { return each.all(); });
  ErrorScale errors = order.conditions.errors;
  errors.variation = tally.variation;
  std::string text =
      fmt::format("{}{}: {}\n", text_of(errors), tally.pace == 1.0 ? "" : fmt::format(", pace {:g}", tally.pace),
                  finished_text_of(counts));
  if (tally.variation > 0.0) {
    text += "\nwalls look, %\n";
    for (std::size_t bright = 0; bright < brightness_classes; ++bright)
      if (const CountsByMaze some = of_brightness(measured, place, bright); some.all.contests > 0)
        text += fmt::format("{:<14} {}\n", name_of_class(bright, brightness_limits), finished_text_of(some));
  }
  const auto heading = [](std::string_view first) {
    return fmt::format("{:<14} {:>9} {:>8} {:>9} {:>15} {:>8}\n", first, "times", "crashes", "of 1000", "95 %",
                       "near %");
  };
  text += "\n" + heading("manoeuvre");
  for (const Manoeuvre manoeuvre : all_manoeuvres)
    text += manoeuvre_line(name_of(manoeuvre), counts, [&](const FailureCounts& some) { return some.of(manoeuvre); });
  text += "\n" + heading("error, %");
  for (std::size_t level = 0; level < position_error_levels; ++level)
    text += manoeuvre_line(name_of_level(level), counts, [&](const FailureCounts& some) { return some.at(level); });
  text += fmt::format("\n{:<14} {:>9} {:>9} {:>15} {:>9} {:>9} {:>15}\n", "readings", "beside", "wrong of", "95 %",
                      "ahead", "wrong of", "95 %");
  text += fmt::format("{:<14} {:>9} {:>9} {:>15} {:>9} {:>9}\n", "error, %", "", "1000", "", "", "1000");
  for (std::size_t level = 0; level < position_error_levels; ++level) text += readings_line(counts, level);
  return text;
}

template <class ShareOf>
Json interval_json(const CountsByMaze& counts, ShareOf share) {
  const Interval interval = counts.interval(share);
  return {interval.low, interval.high};
}

Json manoeuvre_json(const CountsByMaze& counts, Manoeuvre manoeuvre, std::size_t level) {
  const auto of = [&](const FailureCounts& some) -> const ManoeuvreCount& {
    return some.manoeuvres[static_cast<std::size_t>(manoeuvre)][level];
  };
  const ManoeuvreCount& count = of(counts.all);
  return {{"times", count.times},
          {"crashes", count.crashes},
          {"slid", count.slid},
          {"after", count.after},
          {"crash_interval", interval_json(counts, [&](const FailureCounts& some) {
             return Share{of(some).crashes, of(some).times};
           })}};
}

Json reading_json(const CountsByMaze& counts, Reading reading, std::size_t level) {
  const auto of = [&](const FailureCounts& some) -> const ReadingCount& {
    return some.readings[static_cast<std::size_t>(reading)][level];
  };
  const ReadingCount& count = of(counts.all);
  return {{"by_evidence", count.by_evidence},
          {"wrong", count.wrong(reading)},
          {"wrong_interval", interval_json(counts, [&](const FailureCounts& some) {
             return Share{of(some).wrong(reading), of(some).times()};
           })}};
}

Json json_of(const CountsByMaze& by_maze) {
  const FailureCounts& counts = by_maze.all;
  Json json = {{"contests", counts.contests},
               {"finished", counts.finished},
               {"finished_interval", interval_json(by_maze, finished_share)},
               {"put", counts.put}};
  for (const Manoeuvre manoeuvre : all_manoeuvres)
    for (std::size_t level = 0; level < position_error_levels; ++level)
      json["manoeuvres"][std::string(name_of(manoeuvre))].push_back(manoeuvre_json(by_maze, manoeuvre, level));
  for (const Reading reading : all_readings)
    for (std::size_t level = 0; level < position_error_levels; ++level)
      json["readings"][std::string(name_of(reading))].push_back(reading_json(by_maze, reading, level));
  return json;
}

Json json_of(const MeasuredRates& measured, std::size_t place) {
  const FailureTally& tally = measured.tallies[place];
  Json json = {{"variation", tally.variation}, {"pace", tally.pace}};
  for (std::size_t bright = 0; bright < brightness_classes; ++bright)
    json["by_brightness"].push_back(json_of(of_brightness(measured, place, bright)));
  return json;
}

/// The zeros at its end are left out.
template <class Numbers>
Json trimmed(const Numbers& numbers) {
  const auto end = std::find_if(numbers.rbegin(), numbers.rend(), [](std::int64_t one) { return one != 0; }).base();
  return Json(std::vector<std::int64_t>(numbers.begin(), end));
}

/// Counts as a file has them. Of each manoeuvre: how often, crashes, crashes by sliding, and the levels of localization
/// error after the others.
Json counts_json(const FailureCounts& counts) {
  Json json = {{"contests", counts.contests}, {"finished", counts.finished}, {"put", trimmed(counts.put)}};
  for (const Manoeuvre manoeuvre : all_manoeuvres) {
    Json& list = json["manoeuvres"][std::string(name_of(manoeuvre))];
    for (const ManoeuvreCount& count : counts.manoeuvres[static_cast<std::size_t>(manoeuvre)]) {
      std::vector<std::int64_t> numbers = {count.times, count.crashes, count.slid};
      numbers.insert(numbers.end(), count.after.begin(), count.after.end());
      list.push_back(trimmed(numbers));
    }
  }
  for (const Reading reading : all_readings)
    for (const ReadingCount& count : counts.readings[static_cast<std::size_t>(reading)])
      json["readings"][std::string(name_of(reading))].push_back(trimmed(count.by_evidence));
  return json;
}

Json counts_json(const FailureTally& tally) {
  Json json = {{"variation", tally.variation}, {"pace", tally.pace}};
  for (const FailureCounts& counts : tally.by_brightness) json["by_brightness"].push_back(counts_json(counts));
  return json;
}

Json heading_of(const FailureOrder& order, std::span<const Contestant> mice, std::size_t mazes) {
  Json json = {{"edition", physical_edition},
               {"robot", order.model->robot.name},
               {"tables", fmt::format("{:016x}", order.model->tables.hash)},
               {"rules", order.rules.name},
               {"noise", order.conditions.errors.noise},
               {"search_speed", order.conditions.controller.search_speed},
               {"map", std::string(name_of(order.conditions.map))},
               {"seed", order.seed},
               {"runs", order.runs},
               {"mazes", mazes},
               {"error_limits", position_error_limits},
               {"brightness_limits", brightness_limits}};
  for (const Contestant& mouse : mice) json["mice"].push_back(mouse.name);
  return json;
}

}  // namespace

std::string table_of(const MeasuredRates& measured, const FailureOrder& order) {
  std::string text;
  for (std::size_t place = 0; place < measured.tallies.size(); ++place)
    text += (text.empty() ? "" : "\n") + table_of(measured, order, place);
  if (measured.stopped) text += "\nStopped early: not all contests are done.\n";
  return text;
}

std::string json_of(const MeasuredRates& measured, const FailureOrder& order, std::span<const Contestant> mice,
                    std::size_t mazes) {
  Json json = heading_of(order, mice, mazes);
  json["stopped"] = measured.stopped;
  for (std::size_t place = 0; place < measured.tallies.size(); ++place)
    json["variations"].push_back(json_of(measured, place));
  return json.dump() + "\n";
}

std::string write_rates(const MeasuredRates& measured, const FailureOrder& order, std::span<const Contestant> mice,
                        std::size_t mazes) {
  Json json = {{"labmouse_failure_rates", failure_rates_format}};
  json.update(heading_of(order, mice, mazes));
  if (measured.stopped) json["stopped"] = true;
  for (const FailureTally& tally : measured.tallies) json["variations"].push_back(counts_json(tally));
  return json.dump() + "\n";
}

}  // namespace labmouse
