// Names of earlier versions. Files, options and SPECs with these names stay readable; new output has only today's
// names.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace labmouse {

/// A former name and the name of today.
struct FormerName {
  std::string_view former, today;
};

/// Keys of JSON, records and mice files, settings of worlds, and parameters of mice.
inline constexpr std::array former_keys = std::to_array<FormerName>({
    {"exploration_steps", "search_steps"},
    {"mean_exploration_steps", "mean_search_steps"},
    {"exploration_factor", "search_factor"},
    {"solved", "finished"},
    {"scored", "finished"},
    {"mean_solved_score", "mean_finished_score"},
    {"penalised_mean", "mean_par1"},
    {"penalised", "par1"},
    {"strayed", "position_lost"},
    {"misread", "wall_error"},
    {"misreads", "wrong_walls"},
    {"walled_in", "no_route_left"},
    {"frailty", "severity"},
    {"spread", "variation"},
    {"hazards", "failure_rates"},
    {"hazards_hash", "failure_rates_hash"},
    {"labmouse_hazards", "labmouse_failure_rates"},
    {"ranger", "ToF sensor"},
    {"throws_dice", "is_stochastic"},
    {"guest", "program"},
    {"pilot", "controller"},
    {"mind", "strategy"},
    {"hoped", "possible"},
});

/// Outcomes, reasons of forfeits, ends of runs, kinds of maps, and the runs of a record.
inline constexpr std::array former_values = std::to_array<FormerName>({
    {"solved", "finished"},
    {"strayed", "position lost"},
    {"misread", "wall error"},
    {"walled in", "no route left"},
    {"belief", "log-odds"},
    {"learned", "log-odds-prior"},
    {"exploration", "search"},
    {"fast", "speed"},
    {"no way", "no route"},
    {"died", "ended early"},
    {"rubbish", "invalid answer"},
    {"forfeit: no way", "forfeit: no route"},
    {"forfeit: died", "forfeit: ended early"},
    {"forfeit: rubbish", "forfeit: invalid answer"},
});

/// The keys to whose values these names apply.
inline constexpr std::array<std::string_view, 5> keys_of_names = {"outcome", "ended_by", "how", "map", "run"};

/// Today's name of a key; the name itself where it has not changed.
constexpr std::string_view today_key(std::string_view name) {
  for (const FormerName& each : former_keys)
    if (each.former == name) return each.today;
  return name;
}

/// The first name of a key; the name itself where it has not changed.
constexpr std::string_view former_key(std::string_view name) {
  for (const FormerName& each : former_keys)
    if (each.today == name) return each.former;
  return name;
}

constexpr std::string_view today_value(std::string_view value) {
  for (const FormerName& each : former_values)
    if (each.former == value) return each.today;
  return value;
}

constexpr std::string_view former_value(std::string_view value) {
  for (const FormerName& each : former_values)
    if (each.today == value) return each.former;
  return value;
}

/// Prefixes of SPECs of external mice and mice files.
inline constexpr std::array former_kinds =
    std::to_array<FormerName>({{"guest:", "program:"}, {"pilot:", "controller:"}, {"lineup:", "mice-file:"}});

/// A SPEC with today's prefix.
inline std::string today_spec(std::string_view spec) {
  for (const FormerName& each : former_kinds)
    if (spec.starts_with(each.former)) return std::string(each.today) + std::string(spec.substr(each.former.size()));
  return std::string(spec);
}

/// JSON with renamed keys at every depth, and renamed values of `keys_of_names`. `key` and `value` map a name to that
/// of another version, such as today_key() and today_value().
/// @tparam AnyJson Json or ReadJson.
template <class AnyJson>
AnyJson with_names(AnyJson json, std::string_view (*key)(std::string_view),
                   std::string_view (*value)(std::string_view)) {
  if (json.is_array())
    for (AnyJson& item : json) item = with_names(std::move(item), key, value);
  if (!json.is_object()) return json;
  AnyJson renamed = AnyJson::object();
  for (auto& item : json.items()) {
    const bool is_name = std::find(keys_of_names.begin(), keys_of_names.end(), item.key()) != keys_of_names.end();
    renamed[std::string(key(item.key()))] = is_name && item.value().is_string()
                                                ? AnyJson(std::string(value(item.value().template get<std::string>())))
                                                : with_names(std::move(item.value()), key, value);
  }
  return renamed;
}

/// JSON of any version with today's names.
template <class AnyJson>
AnyJson with_today_names(AnyJson json) {
  return with_names(std::move(json), today_key, today_value);
}

}  // namespace labmouse
