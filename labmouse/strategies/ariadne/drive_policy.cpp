#include "labmouse/strategies/ariadne/drive_policy.hpp"

namespace labmouse::ariadne {
namespace {

int in_parts_of_a_nat(double nats) { return static_cast<int>(32 * nats); }

}  // namespace

DrivePolicy::DrivePolicy(const Settings& settings)
    : corner_turn(settings.real("corner_turn")),
      corner_time(settings.real("corner_time")),
      home_turn(settings.real("home_turn")),
      home_back(settings.real("home_back")),
      home_cells_a_nat(settings.real("home_slope")),
      home_cells_a_wall(settings.real("home_base")),
      home_closed(in_parts_of_a_nat(settings.real("home_closed"))),
      run_a_nat(static_cast<int>(settings.real("run_slope"))),
      run_a_wall(static_cast<int>(settings.real("run_base"))),
      run_closed(in_parts_of_a_nat(settings.real("run_closed"))),
      run_longest(settings.real("run_longest")),
      run_gain(static_cast<int>(settings.real("run_gain"))),
      cell_most(settings.real("cell_most")),
      cell_least(settings.real("cell_least")),
      cell_worth(settings.real("cell_worth")),
      look_most(settings.real("look_most")),
      look_worth(settings.real("look_worth")),
      chance(settings.real("chance")),
      sure_gain(settings.real("sure_gain")),
      way_cells_a_nat(settings.real("way_slope")),
      way_news(settings.real("way_news")),
      hope_closed(in_parts_of_a_nat(settings.real("hope_closed"))),
      hope_gain(settings.real("hope_gain")),
      hope_chance(settings.real("hope_chance")),
      last_gain(settings.real("last_gain")) {}

}  // namespace labmouse::ariadne
