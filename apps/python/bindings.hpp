// The extension labmouse._native: each file binds one topic, and module.cpp calls them all.
#pragma once

#include <nanobind/nanobind.h>

namespace labmouse::python {

/// Each adds the classes and functions of one topic to the module.
void bind_errors(nanobind::module_& module);
void bind_mazes(nanobind::module_& module);
void bind_sightings(nanobind::module_& module);
void bind_briefings(nanobind::module_& module);
void bind_live_strategies(nanobind::module_& module);
void bind_races(nanobind::module_& module);
void bind_robots(nanobind::module_& module);
void bind_records(nanobind::module_& module);
void bind_bounds(nanobind::module_& module);
void bind_learning(nanobind::module_& module);
void bind_studies(nanobind::module_& module);
void bind_comparisons(nanobind::module_& module);
void bind_seasons(nanobind::module_& module);
void bind_real_robots(nanobind::module_& module);

}  // namespace labmouse::python
