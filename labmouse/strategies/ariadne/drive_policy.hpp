// Parameters of ariadne in the world of seconds.
#pragma once

#include <array>
#include <string_view>

#include "labmouse/strategies/parameter.hpp"

namespace labmouse::ariadne {

/// Units: a "cell" is the search time of one cell, a "nat" one unit of -ln P(open).
struct DrivePolicy {
  /// On the way to the goal, a turn costs at most this many cells, because corners show more of a maze. If the maze
  /// time does not count, this holds only for the first `corner_time` of the time limit.
  double corner_turn, corner_time;

  /// On the way home: factors on the times of quarter turns and of turning back; the cost of an unseen wall (per nat,
  /// and a constant); and the price in 1/32 nat from which it counts as closed.
  double home_turn, home_back;
  double home_cells_a_nat, home_cells_a_wall;
  int home_closed;

  /// For a possible speed run: the cost of unseen walls in milliseconds (per nat, and a constant), and the price in
  /// 1/32 nat from which they count as closed; the longest run considered, as a multiple of the best known one; and the
  /// part of the gain that does not count, in milliseconds.
  int run_a_nat, run_a_wall, run_closed;
  double run_longest;
  int run_gain;

  /// If the maze time counts: the highest worth of the gain through an unseen cell, in cells (cell_most), and the
  /// search time in s that a gain of 1 s is worth at a maze time divisor of 30, in proportion at others (cell_worth).
  /// cell_least, in cells, is added wherever there is a gain, under all rules.
  double cell_most, cell_least, cell_worth;
  /// If it does not count: the highest worth, in cells, and the search time in s that a gain of 1 s is worth.
  double look_most, look_worth;
  /// Exponent of the probability that a possible run exists, in the worth of its gain; and the gain that counts in
  /// full, as a share of the best known run.
  double chance, sure_gain;

  /// On the way to a cell from which an unseen wall can be read: in mazes of up to RunCosts::largest_area, the cost of
  /// an unseen wall in cells per nat; in larger ones, the discount in cells for entering an unseen cell. There is no
  /// discount if the time limit is too short to enter all cells.
  double way_cells_a_nat, way_news;

  /// In mazes of up to RunCosts::largest_area: walls of that price or more, in 1/32 nat, are not part of
  /// possible routes.
  int hope_closed;
  /// A possible route is explored if gain * probability^hope_chance is at least hope_gain * known time. Once routes
  /// through unlikely walls are considered, the gain must be at least last_gain * known time.
  double hope_gain, hope_chance, last_gain;

  explicit DrivePolicy(const Settings& settings);
};

constexpr Parameter number_in_seconds(std::string_view name, std::string_view value, double low, double high,
                                      std::string_view meaning) {
  return Parameter::real(name, value, low, high, meaning, ParameterScope::seconds);
}

/// The parameters that DrivePolicy reads.
///
/// Tuned on 257 contest mazes by CMA-ES for the mean of three robots (`classic`, `kerise`, `beginner`) under
/// `thirtieth`. `corner_time`, look_*, way_* and hope_* were tuned one by one.
/// docs/explanation/how-ariadne-explores.md has the effect of each, also in mazes not used for tuning.
inline constexpr std::array drive_parameters = {
    number_in_seconds(
        "corner_turn", "0.62", 0, 10,
        "Highest time that a turn counts in the plan until the goal is entered, in search times of one cell."),
    number_in_seconds("corner_time", "0.16667", 0, 1,
                      "Where the time in the maze does not count: corner_turn applies during this share of the time "
                      "limit (no unit)."),
    number_in_seconds("home_turn", "1.33", 0, 10,
                      "Factor on the time of a turn of 90 degrees in plans of the way home (no unit)."),
    number_in_seconds("home_back", "0.7", 0, 10,
                      "Factor on the time of a turn of 180 degrees in plans of the way home (no unit)."),
    number_in_seconds(
        "home_slope", "2.77", 0, 100,
        "Price of an unseen wall on the way home: search times of one cell for each unit of -ln P(open)."),
    number_in_seconds(
        "home_base", "0.04", 0, 100,
        "Price of each unseen wall on the way home, added to that of home_slope, in search times of one cell."),
    number_in_seconds(
        "home_closed", "1.91", 0.05, 7,
        "On the way home, an unseen wall counts as closed if its -ln P(open) is at least this (no unit)."),
    number_in_seconds("run_slope", "128", 0, 2000,
                      "Price of an unseen wall in a possible speed run: ms for each unit of -ln P(open)."),
    number_in_seconds("run_base", "5", 0, 500,
                      "Price of each unseen wall in a possible speed run, added to that of run_slope, in ms."),
    number_in_seconds(
        "run_closed", "3.91", 0.05, 7,
        "In a possible speed run, an unseen wall counts as closed if its -ln P(open) is at least this (no unit)."),
    number_in_seconds(
        "run_longest", "1.12", 0.5, 5,
        "Longest possible speed run that is considered, as a multiple of the time of the best known one (no unit)."),
    number_in_seconds("run_gain", "37", 0, 2000,
                      "Part of the gain of a possible speed run over the best known one that does not count, in ms."),
    number_in_seconds("cell_most", "0.76", 0, 10,
                      "Where the time in the maze counts: the most that the gain through an unseen cell is worth, in "
                      "search times of one cell."),
    number_in_seconds("cell_least", "0.017", 0, 10,
                      "Worth of each unseen cell through which a gain is possible, added to the worth of the gain, in "
                      "search times of one cell."),
    number_in_seconds("cell_worth", "0.94", 0, 100,
                      "Where the time in the maze counts: s of search that a gain of 1 s is worth under rules with a "
                      "thirtieth; in proportion under others."),
    number_in_seconds("look_most", "0.6", 0, 10,
                      "Where the time in the maze does not count: the most that the gain through an unseen cell is "
                      "worth, in search times of one cell."),
    number_in_seconds("look_worth", "4.7", 0, 100,
                      "Where the time in the maze does not count: s of search that a gain of 1 s is worth."),
    number_in_seconds(
        "chance", "0.64", 0, 4,
        "Exponent of the probability that a possible speed run exists, in the worth of its gain (no unit)."),
    number_in_seconds("sure_gain", "0.1", 0.001, 10,
                      "Gain that counts in full, as a share of the time of the best known run; smaller gains count "
                      "less, larger ones more (no unit)."),
    number_in_seconds("way_slope", "0.8", 0, 100,
                      "In mazes of up to 256 cells: price of an unseen wall on the way to a look, search times of one "
                      "cell for each unit of -ln P(open)."),
    number_in_seconds("way_news", "0.4", 0, 10,
                      "In mazes of more than 256 cells: time that entering an unseen cell on the way to a look saves, "
                      "in search times of one cell."),
    number_in_seconds(
        "hope_closed", "0.79", 0.05, 7,
        "In mazes of up to 256 cells: possible routes pass no wall with at least this -ln P(open) (no unit)."),
    number_in_seconds(
        "hope_gain", "0.017", 0, 1,
        "In mazes of up to 256 cells: least gain that is worth a look, as a share of the best known time (no unit)."),
    number_in_seconds(
        "hope_chance", "0.125", 0, 4,
        "In mazes of up to 256 cells: exponent of the probability that the route of that gain exists (no unit)."),
    number_in_seconds("last_gain", "0.3", 0, 1,
                      "Least gain that is worth a look once routes through unlikely walls are considered too, as a "
                      "share of the best known time (no unit)."),
};

}  // namespace labmouse::ariadne
