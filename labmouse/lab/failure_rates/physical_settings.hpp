// Settings of contests with errors. Worlds, records and files of failure rates use them.
#pragma once

#include <array>

#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/lab/races/world_setting.hpp"

namespace labmouse {

inline constexpr std::array map_kind_names = {name_of(MapKind::first), name_of(MapKind::log_odds),
                                              name_of(MapKind::learned)};

using PhysicalRow = SettingRow<PhysicalConditions>;

inline constexpr PhysicalRow noise_row = row<&PhysicalConditions::errors, &ErrorScale::noise>(
    {.name = "noise",
     .placeholder = "FACTOR",
     .meaning =
         "Scale of the noise of each moment: 1 as measured, 0 none; several, separated by commas, give a race each",
     .default_value = "1",
     .high = most_noise,
     .listed = true});
inline constexpr PhysicalRow variation_row = row<&PhysicalConditions::errors, &ErrorScale::variation>(
    {.name = "variation",
     .placeholder = "FACTOR",
     .meaning =
         "Scale of the variation between mice, mazes and days, or its name: lab (0), practice (0.5), contest (1), "
         "bad-day (1.2); several, separated by commas, give a race each",
     .default_value = "1",
     .high = most_variation,
     .named = variation_levels,
     .listed = true});
inline constexpr PhysicalRow search_speed_row = row<&PhysicalConditions::controller, &ControllerChoice::search_speed>(
    {.name = "search-speed",
     .placeholder = "SPEED",
     .meaning = "Speed of the search run in mm/s; 0: the robot's own",
     .default_value = "0",
     .high = most_search_speed,
     .least_chosen = least_search_speed,
     .unit = "mm/s"});
inline constexpr PhysicalRow pace_row = row<&PhysicalConditions::controller, &ControllerChoice::pace>(
    {.name = "pace",
     .placeholder = "SHARE",
     .meaning = "Share of the robot's usual speed, on the same paths",
     .default_value = "1",
     .low = least_pace,
     .high = 1.0,
     .later = true});
inline constexpr PhysicalRow map_row = {
    {.name = "map",
     .meaning =
         "How contradicting wall readings are handled: the first one stays (first), or a log-odds map weighs them "
         "(log-odds), with a prior learned from other mazes (log-odds-prior)",
     .default_value = "first",
     .choices = map_kind_names,
     .later = true},
    [](const PhysicalConditions& conditions) { return Value(std::string(name_of(conditions.map))); },
    [](const Value& value, PhysicalConditions& conditions) {
      conditions.map = map_kind_of(text_of(value)).value_or(MapKind::first);
    }};

/// Those of the physical world, in the order of its conditions.
inline constexpr std::array physical_rows = {noise_row, variation_row, search_speed_row, pace_row, map_row};
/// Those of the failure model. Its failure rates determine the others.
inline constexpr std::array failures_rows = {variation_row, pace_row, map_row};

}  // namespace labmouse
