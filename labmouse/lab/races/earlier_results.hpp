// The results of earlier versions.
#pragma once

#include <utility>

#include "labmouse/lab/text/former_names.hpp"

namespace labmouse {

/// The results of a race as they are written now. Earlier versions wrote a race in steps at the top
/// level, and only races in other worlds in `groups`; and some keys had other names. Other JSON is returned unchanged.
/// @tparam AnyJson Json or ReadJson.
template <class AnyJson>
AnyJson with_groups(AnyJson results) {
  results = with_today_names(std::move(results));
  if (!results.is_object() || !results.contains("mice")) return results;
  if (results.contains("groups") && !results["groups"].is_array()) return results;
  AnyJson groups = AnyJson::array();
  if (!results["mice"].is_array() || !results["mice"].empty()) {
    AnyJson group = {{"world", "steps"}, {"formula", "speed-run steps + search steps / 30"}};
    for (const char* key : {"budget", "stopped", "notes", "mazes", "mice"})
      if (results.contains(key)) group[key] = results[key];
    groups.push_back(std::move(group));
  }
  if (results.contains("groups"))
    for (AnyJson& group : results["groups"]) groups.push_back(std::move(group));
  for (const char* key : {"budget", "notes", "mazes", "mice"}) results.erase(key);
  results["groups"] = std::move(groups);
  return results;
}

}  // namespace labmouse
