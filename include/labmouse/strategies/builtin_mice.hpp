// The built-in mice, in two tables.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/strategy.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Makes a mouse for a briefing in steps. The settings must be those of its parameters, and outlive the mouse.
using MouseFactory = std::unique_ptr<Strategy> (*)(const Briefing& briefing, const Settings& settings);
/// Makes a mouse for a briefing in seconds. The settings must be those of its parameters, and outlive the mouse.
using DriverFactory = std::unique_ptr<DrivingStrategy> (*)(const Briefing& briefing, const Settings& settings);

/// The factory of a mouse in seconds, or null in programs for steps alone, such as firmware (LABMOUSE_STEPS_ALONE, for
/// all sources): then the linker leaves out all that plans in seconds.
/// @param factory of that mouse.
constexpr DriverFactory factory_in_seconds([[maybe_unused]] DriverFactory factory) {
#if defined(LABMOUSE_STEPS_ALONE)
  return nullptr;
#else
  return factory;
#endif
}

/// One built-in mouse: name, summary, method, source of the idea, parameters, and factories. Each strategy's file
/// defines its own.
struct BuiltinMouse {
  std::string_view name;     ///< as in a SPEC
  std::string_view summary;  ///< one line, for lists of mice
  std::string_view method;   ///< how it works, for its own page
  std::string_view source;   ///< where the idea comes from
  /// Its parameters, in the order in which they are listed, in static memory.
  std::span<const Parameter> parameters = {};
  /// Makes it for a briefing in steps; null if it does not race in steps.
  MouseFactory make = nullptr;
  /// Whether it is stochastic under given settings, so that races repeat its runs.
  /// @param settings those of its parameters.
  bool (*uses_chance)(const Settings& settings) = never;

  /// Makes it for a briefing in seconds; null if it does not race in seconds.
  DriverFactory drive = nullptr;

  /// Whether it races in steps.
  bool walks() const { return make != nullptr; }
  /// Whether it races in seconds.
  bool drives() const { return drive != nullptr; }

  /// For `uses_chance`: it is never stochastic.
  /// @return false.
  static bool never(const Settings&) { return false; }
  /// For `uses_chance`: it is always stochastic.
  /// @return true.
  static bool always(const Settings&) { return true; }
};

extern const BuiltinMouse random_move_mouse;
extern const BuiltinMouse dead_end_mouse;
extern const BuiltinMouse visit_counter_mouse;
extern const BuiltinMouse random_mouse;
extern const BuiltinMouse random_then_shortest_mouse;
extern const BuiltinMouse cautious_mouse;
extern const BuiltinMouse wall_left_mouse;
extern const BuiltinMouse wall_right_mouse;
extern const BuiltinMouse manhattan_mouse;
extern const BuiltinMouse frontier_mouse;
extern const BuiltinMouse potential_mouse;
extern const BuiltinMouse two_way_mouse;
extern const BuiltinMouse flood_explore_mouse;
extern const BuiltinMouse flood_block_mouse;
extern const BuiltinMouse phases_mouse;
extern const BuiltinMouse flood_mouse;
extern const BuiltinMouse flood_return_mouse;
extern const BuiltinMouse certify_mouse;
extern const BuiltinMouse ariadne_mouse;
extern const BuiltinMouse ariadne_deep_mouse;
extern const BuiltinMouse festina_mouse;

/// All that race in steps, from the simplest to the best.
std::span<const BuiltinMouse* const> builtin_mice();
/// Those that race only in seconds.
std::span<const BuiltinMouse* const> only_drivers();
/// All of both.
std::vector<const BuiltinMouse*> all_mice();

/// Finds a mouse in both tables.
/// @param name exactly, without parameters.
/// @return the entry, in static memory; null if there is none of that name.
const BuiltinMouse* find_mouse(std::string_view name);

}  // namespace labmouse
