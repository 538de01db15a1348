#include "labmouse/strategies/ariadne/policy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace labmouse::ariadne {
namespace {

constexpr std::array parameters = {
    Parameter::prior("prior", "contest", "contest/uniform", "what it expects of unseen walls", ParameterScope::both),
    Parameter::choice(
        "model", "smooth", "smooth/classes/flat/free",
        "price of an unseen wall: by its likelihood of being closed, by classes of that, the same for all, or "
        "none; all but smooth are simpler mice for comparison, with fixed numbers"),
    Parameter::choice("style", "auto", "auto/contest/loop-free",
                      "loop-free stops at the goal; auto does so if the walls look like those of a maze without loops"),
    Parameter::real("base", "5.11", 0, 100, "before the goal: price of an unseen wall, in 1/30 step"),
    Parameter::real("slope", "10.08", 0, 100, "added for each unit of -ln P(open)"),
    Parameter::real("closed", "2.73", 0.05, 7, "assumed closed from this -ln P(open) on"),
    Parameter::real("way_here", "0", 0, 1, "weight of the way from the start to the wall"),
    Parameter::real("travel", "40.57", 1, 200, "price of a step towards a wall, in 1/30 step"),
    Parameter::real("insight", "0.21", 0, 50, "bonus for each unseen wall that can be seen from there"),
    Parameter::real("goal_bonus", "26.9", 0, 200, "bonus for the goal itself"),
    Parameter::real("base_after", "6.47", 0, 100, "after the goal: the same as base"),
    Parameter::real("slope_after", "12.49", 0, 100, "the same as slope"),
    Parameter::real("closed_after", "2.86", 0.05, 7, "the same as closed"),
    Parameter::real("travel_after", "38.19", 1, 200, "the same as travel"),
    Parameter::real("insight_after", "0.31", 0, 50, "the same as insight"),
    Parameter::real("stop_travel", "1.566", 0, 20, "price of a step, in 1/30 step, when deciding whether to stop"),
    Parameter::real("stop_margin", "2.67", -60, 60, "how much more a look may cost than it could save, in 1/30 step"),
};

int weight(double value) { return static_cast<int>(value * one + (value < 0 ? -0.5 : 0.5)); }

/// A price for each reluctance; `price` takes it as -ln P(open).
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
  // The simpler models know nothing of what contest mazes are like but by their prices.
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

/// A step towards a wall costs what a step of a run costs; no bonus, no margin.
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
