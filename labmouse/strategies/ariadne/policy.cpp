#include "labmouse/strategies/ariadne/policy.hpp"

#include <algorithm>
#include <array>

namespace labmouse::ariadne {
namespace {

constexpr std::array parameters = {
    Parameter{"prior", ParameterType::choice, "contest", 0, 0, "contest/uniform", "what it expects of unseen walls"},
    Parameter{"model", ParameterType::choice, "smooth", 0, 0, "smooth/classes/flat/free",
              "price of an unseen wall: by how likely it is closed, in three classes of that, all alike, or none"},
    Parameter{"style", ParameterType::choice, "auto", 0, 0, "auto/contest/loop-free",
              "loop-free stops at the goal; auto does so where the walls look like those of a maze without loops"},
    Parameter{"base", ParameterType::real, "5.11", 0, 100, "", "before the goal: price of an unseen wall, in 1/30 step"},
    Parameter{"slope", ParameterType::real, "10.08", 0, 100, "", "and for each unit of -ln P(open)"},
    Parameter{"closed", ParameterType::real, "2.73", 0.05, 7, "", "taken for closed from this -ln P(open)"},
    Parameter{"way_here", ParameterType::real, "0", 0, 1, "", "weight of the way from the start to the wall"},
    Parameter{"travel", ParameterType::real, "40.57", 1, 200, "", "price of a step towards a wall, in 1/30 step"},
    Parameter{"insight", ParameterType::real, "0.21", 0, 50, "", "bonus for each unseen wall that is seen from there"},
    Parameter{"goal_bonus", ParameterType::real, "26.9", 0, 200, "", "bonus for the goal itself"},
    Parameter{"base_after", ParameterType::real, "6.47", 0, 100, "", "after the goal: the same as base"},
    Parameter{"slope_after", ParameterType::real, "12.49", 0, 100, "", "the same as slope"},
    Parameter{"closed_after", ParameterType::real, "2.86", 0.05, 7, "", "the same as closed"},
    Parameter{"travel_after", ParameterType::real, "38.19", 1, 200, "", "the same as travel"},
    Parameter{"insight_after", ParameterType::real, "0.31", 0, 50, "", "the same as insight"},
    Parameter{"stop_travel", ParameterType::real, "1.566", 0, 20, "", "price of a step, in 1/30 step, where it asks whether to stop"},
    Parameter{"stop_margin", ParameterType::real, "2.67", -60, 60, "", "what a look may cost more than it could save, in 1/30 step"},
};

int weight(double value) { return static_cast<int>(value * one + (value < 0 ? -0.5 : 0.5)); }

/// How an unseen wall is priced.
struct Pricing {
  std::string_view model;
  double base, slope, closed;

  int price(int reluctance) const {
    const double nats = reluctance / 32.0;
    if (model == "free") return 0;
    if (model == "flat") return static_cast<int>(base + 0.5);
    if (nats >= closed) return WallPrices::closed;
    const double price = model == "classes" ? (nats < slope ? base : 2 * base) : reluctance > 0 ? base + slope * nats : 0;
    return std::min(static_cast<int>(price + 0.5), WallPrices::highest);
  }
  PriceTable table() const {
    PriceTable prices;
    for (unsigned reluctance = 0; reluctance < prices.size(); ++reluctance)
      prices[reluctance] = static_cast<std::uint8_t>(price(static_cast<int>(reluctance)));
    return prices;
  }
};

}  // namespace

Policy::Policy(const Settings& settings) {
  const auto model = settings.choice("model"), style = settings.choice("style");
  const Pricing pricing{model, settings.real("base"), settings.real("slope"), settings.real("closed")};
  before.prices = pricing.table();
  after.prices = Pricing{model, settings.real("base_after"), settings.real("slope_after"), settings.real("closed_after")}.table();
  last_resort = Pricing{model, pricing.base, pricing.slope, 1000}.table();
  before.way_here = weight(settings.real("way_here"));
  after.way_here = one;
  before.travel = weight(settings.real("travel"));
  after.travel = weight(settings.real("travel_after"));
  before.insight = weight(settings.real("insight"));
  after.insight = weight(settings.real("insight_after"));
  goal_bonus = weight(settings.real("goal_bonus"));
  stop_travel = weight(settings.real("stop_travel"));
  stop_margin = weight(settings.real("stop_margin"));
  loop_free = style == "loop-free";
  may_be_loop_free = style == "auto";
}

std::span<const Parameter> policy_parameters() { return parameters; }

}  // namespace labmouse::ariadne
