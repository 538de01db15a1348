#include "labmouse/strategies/ariadne/policy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace labmouse::ariadne {
namespace {

constexpr std::array parameters = {
    Parameter::prior("prior", "contest", "contest/uniform",
                     "How likely unseen walls are expected to be closed: as in contest mazes, all equally (uniform), "
                     "or as a file says.",
                     ParameterScope::both),
    Parameter::choice("model", "smooth", "smooth/classes/flat/free",
                      "Price of an unseen wall: grows with its likelihood of being closed (smooth), has a value for "
                      "each of three classes of it (classes), is the same for all walls (flat) or 0 (free). All but "
                      "smooth have fixed numbers and ignore the other numbers that count only in steps."),
    Parameter::choice("style", "auto", "auto/contest/loop-free",
                      "When to stop at the goal without exploring on: always (loop-free), never (contest), or if the "
                      "walls look like those of a maze without loops (auto)."),
    Parameter::real("base", "5.11", 0, 100, "Price of each unseen wall until the goal is entered, in 1/30 step."),
    Parameter::real(
        "slope", "10.08", 0, 100,
        "Price of an unseen wall until the goal is entered, added to base: 1/30 steps for each unit of -ln P(open)."),
    Parameter::real(
        "closed", "2.73", 0.05, 7,
        "Until the goal is entered, an unseen wall counts as closed if its -ln P(open) is at least this (no unit)."),
    Parameter::real("way_here", "0", 0, 1,
                    "Until the goal is entered: weight of the cost from the start to the wall, in the cost of a run "
                    "through it (no unit)."),
    Parameter::real("travel", "40.57", 1, 200,
                    "Price of each step to where a wall can be seen, until the goal is entered, in 1/30 step."),
    Parameter::real(
        "insight", "0.21", 0, 50,
        "Bonus for each unseen wall that can be seen from the same cell, until the goal is entered, in 1/30 step."),
    Parameter::real("goal_bonus", "26.9", 0, 200, "Bonus for going into the goal instead of to a wall, in 1/30 step."),
    Parameter::real("base_after", "6.47", 0, 100,
                    "Price of each unseen wall after the goal was entered, in 1/30 step."),
    Parameter::real("slope_after", "12.49", 0, 100,
                    "Price of an unseen wall after the goal was entered, added to base_after: 1/30 steps for each unit "
                    "of -ln P(open)."),
    Parameter::real(
        "closed_after", "2.86", 0.05, 7,
        "After the goal was entered, an unseen wall counts as closed if its -ln P(open) is at least this (no unit)."),
    Parameter::real("travel_after", "38.19", 1, 200,
                    "Price of each step to where a wall can be seen, after the goal was entered, in 1/30 step."),
    Parameter::real(
        "insight_after", "0.31", 0, 50,
        "Bonus for each unseen wall that can be seen from the same cell, after the goal was entered, in 1/30 step."),
    Parameter::real("stop_travel", "1.566", 0, 20,
                    "Price of each step to a wall when the mouse decides whether to stop, in 1/30 step."),
    Parameter::real("stop_margin", "2.67", -60, 60,
                    "A wall is still worth a look if it costs up to this much more than it could save, in 1/30 step."),
};

int weight(double value) { return static_cast<int>(value * one + (value < 0 ? -0.5 : 0.5)); }

/// Tabulates `price`, a function of -ln P(open), by reluctance.
template <class Price>
PriceTable table_of(Price price) {
  PriceTable table;
  for (unsigned reluctance = 0; reluctance < table.size(); ++reluctance)
    table[reluctance] = static_cast<std::uint8_t>(price(reluctance / 32.0));
  return table;
}

PriceTable smooth(double base, double slope, double closed) {
  return table_of([=](double nats) {
    if (nats >= closed) return WallPrices::closed;
    return nats == 0 ? 0 : std::min(static_cast<int>(std::lround(base + slope * nats)), WallPrices::highest);
  });
}

PriceTable classes(double closed) {
  constexpr int price = 10;
  constexpr double dear = 0.92;  // P(open) = 0.4
  return table_of([=](double nats) { return nats >= closed ? WallPrices::closed : nats >= dear ? 2 * price : price; });
}

PriceTable flat(int price) {
  return table_of([=](double) { return price; });
}

constexpr double never = 1000;

}  // namespace

Policy::Policy(const Settings& settings) {
  const auto style = settings.choice("style");
  loop_free = style == "loop-free";
  // The simpler models do not use the evidence against loops.
  may_be_loop_free = style == "auto" && settings.choice("model") == "smooth";
  after.way_here = one;
  if (settings.choice("model") == "smooth")
    take_numbers(settings);
  else
    take_model(settings.choice("model"));
}

void Policy::take_numbers(const Settings& settings) {
  const double base = settings.real("base"), slope = settings.real("slope");
  before.prices = smooth(base, slope, settings.real("closed"));
  last_resort = smooth(base, slope, never);
  after.prices = smooth(settings.real("base_after"), settings.real("slope_after"), settings.real("closed_after"));
  before.way_here = weight(settings.real("way_here"));
  before.travel = weight(settings.real("travel"));
  after.travel = weight(settings.real("travel_after"));
  before.insight = weight(settings.real("insight"));
  after.insight = weight(settings.real("insight_after"));
  goal_bonus = weight(settings.real("goal_bonus"));
  stop_travel = weight(settings.real("stop_travel"));
  stop_margin = weight(settings.real("stop_margin"));
}

/// A step towards a wall costs as much as a step of a run; there is no bonus and no margin.
void Policy::take_model(std::string_view model) {
  before.prices = model == "classes" ? classes(2.7) : flat(model == "flat" ? 10 : 0);
  last_resort = model == "classes" ? classes(never) : before.prices;
  after.prices = before.prices;
  before.travel = after.travel = step_price * one;
}

constinit const std::array<Parameter, parameters.size() + drive_parameters.size()> fast_parameters = [] {
  std::array<Parameter, parameters.size() + drive_parameters.size()> table;
  std::copy(drive_parameters.begin(), drive_parameters.end(),
            std::copy(parameters.begin(), parameters.end(), table.begin()));
  return table;
}();

constinit const std::array<Parameter, 17> deep_parameters = [] {
  auto table = parameters;
  for (Parameter& parameter : table)
    if (parameter.name == "way_here") parameter.default_value = "0.131";
  return table;
}();

}  // namespace labmouse::ariadne
