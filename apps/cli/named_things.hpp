// Lists of built-in things by their names.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/strategies/parameter.hpp"

namespace labmouse::cli {

/// The names of all, separated by commas.
template <class Things>
std::string list_of(const Things& things) {
  std::string names;
  for (const auto* thing : things) names += (names.empty() ? "" : ", ") + std::string(thing->name);
  return names;
}

/// What to write instead of a word that is none of the names: the nearest one, or one of the list.
template <class Things>
std::string suggestion(std::string_view word, const Things& things) {
  std::vector<std::string_view> names;
  for (const auto* thing : things) names.push_back(thing->name);
  const auto near = nearest_name(word, names);
  return near.empty() ? "expected one of " + list_of(things) : fmt::format("did you mean '{}'?", near);
}

}  // namespace labmouse::cli
