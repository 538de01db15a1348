// What ariadne weighs against what in the world of seconds: its parameters there.
#pragma once

#include <array>
#include <string_view>

#include "labmouse/strategies/parameter.hpp"

namespace labmouse::ariadne {

/// "Cells" are times of a search through a cell, "nats" units of -ln P(open).
struct DrivePolicy {
  /// To the goal, no turn takes longer than this part of a cell: corners show more of a maze. Where the time in the
  /// maze does not count, after this part of the time allowed it matters more to arrive.
  double corner_turn, corner_time;

  /// On the way home: factors of the times of turns, and of turning back; what an unseen wall costs; and one of that
  /// price or more, in 1/32 nat, is taken for closed.
  double home_turn, home_back;
  double home_cells_a_nat, home_cells_a_wall;
  int home_closed;

  /// What unseen walls cost a hoped-for run, in milliseconds, and from which price in 1/32 nat on they are taken for
  /// closed; the longest run that is hoped for, as a part of the best known one; and the least gain, in milliseconds.
  int run_a_nat, run_a_wall, run_closed;
  double run_longest;
  int run_gain;

  /// Where the time in the maze counts: what an unseen cell is worth, at most and at least, in cells, and what a
  /// millisecond of the gain is, as a part of what the rules say.
  double cell_most, cell_least, cell_worth;
  /// Where it does not: the same, at most and by millisecond of the gain.
  double look_most, look_worth;
  /// The power of the chance that a hoped-for run exists, in its gain; and the gain that is as good as sure, as a part
  /// of the best known run.
  double chance, sure_gain;

  /// On the way to a look: what an unseen wall costs in cells a nat, in mazes as small as those that the prior was made
  /// for; and in larger ones the part of a cell that entering an unseen one saves: it will be asked for sooner or
  /// later, unless the time ends before.
  double way_cells_a_nat, way_news;

  /// Walls of that price or more, in 1/32 nat, are no hope for a route, in mazes as small as those that the prior was
  /// made for: there are runs (RunCosts).
  int hope_closed;
  /// A route is a reason to look if it saves such a part of the known one; counted is what it saves times this power of
  /// its chance. And one through unlikely walls, if it saves such a part.
  double hope_gain, hope_chance, last_gain;

  explicit DrivePolicy(const Settings& settings);
};

constexpr Parameter number_in_seconds(std::string_view name, std::string_view value, double low, double high,
                                      std::string_view meaning) {
  return Parameter::real(name, value, low, high, meaning, ParameterScope::seconds);
}

/// The parameters that DrivePolicy reads.
///
/// Found on 257 contest mazes by CMA-ES, all at once, for the mean of three robots (`classic`, `kerise`, `beginner`)
/// under `thirtieth`, November 2026, but for `corner_time` and those of looks, ways and hopes, which were tried one by
/// one; docs/explanation/how-ariadne-explores.md says what each is worth, and what is left of that in mazes that were
/// not used.
inline constexpr std::array drive_parameters = {
    number_in_seconds("corner_turn", "0.62", 0, 10, "before the goal: no turn takes longer than this part of a cell"),
    number_in_seconds("corner_time", "0.16667", 0, 1,
                      "where the time in the maze does not count: up to this part of the time allowed"),
    number_in_seconds("home_turn", "1.33", 0, 10, "on the way home: factor of the time of a turn"),
    number_in_seconds("home_back", "0.7", 0, 10, "of turning back"),
    number_in_seconds("home_slope", "2.77", 0, 100, "price of an unseen wall, in cells, for each unit of -ln P(open)"),
    number_in_seconds("home_base", "0.04", 0, 100, "and of each"),
    number_in_seconds("home_closed", "1.91", 0.05, 7, "assumed closed from this -ln P(open) on"),
    number_in_seconds("run_slope", "128", 0, 2000,
                      "price of an unseen wall to a hoped-for run, in ms, for each unit of -ln P(open)"),
    number_in_seconds("run_base", "5", 0, 500, "and of each"),
    number_in_seconds("run_closed", "3.91", 0.05, 7, "assumed closed from this -ln P(open) on"),
    number_in_seconds("run_longest", "1.12", 0.5, 5,
                      "the longest run that is hoped for, as a part of the best known one"),
    number_in_seconds("run_gain", "37", 0, 2000, "the least gain, in ms"),
    number_in_seconds("cell_most", "0.76", 0, 10,
                      "where the time in the maze counts: what an unseen cell is worth at most, in cells"),
    number_in_seconds("cell_least", "0.017", 0, 10, "at least"),
    number_in_seconds("cell_worth", "0.94", 0, 100, "of what the rules say that a gain is worth"),
    number_in_seconds("look_most", "0.6", 0, 10, "where it does not count: the same as cell_most"),
    number_in_seconds("look_worth", "4.7", 0, 100, "time of the search that a gain is worth"),
    number_in_seconds("chance", "0.64", 0, 4, "power of the chance that a hoped-for run exists"),
    number_in_seconds("sure_gain", "0.1", 0.001, 10, "a gain that is as good as sure, as a part of the best known run"),
    number_in_seconds("way_slope", "0.8", 0, 100, "on the way to a look: the same as home_slope"),
    number_in_seconds("way_news", "0.4", 0, 10,
                      "in mazes of more than 256 cells: part of a cell that entering an unseen one saves"),
    number_in_seconds("hope_closed", "0.79", 0.05, 7,
                      "in smaller ones: no route is hoped for through walls of this -ln P(open)"),
    number_in_seconds("hope_gain", "0.017", 0, 1, "the least part of the known time that a look has to save"),
    number_in_seconds("hope_chance", "0.125", 0, 4, "power of the chance that it does"),
    number_in_seconds("last_gain", "0.3", 0, 1, "the least part through unlikely walls"),
};

}  // namespace labmouse::ariadne
