#include "labmouse/lab/page/world_tables.hpp"

#include <algorithm>

#include "labmouse/lab/races/world_entry.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/entering.hpp"

namespace labmouse {
namespace {

Json column_json(const Column& column) {
  std::string title = columns::heading(column.first, column.second);
  if (title.ends_with(',')) title.pop_back();  // before the unit, which is that of the race
  Json json = {{"key", column.key}, {"title", title}, {"meaning", column.meaning}, {"digits", column.digits}};
  if (column.factor != 1.0) json["factor"] = column.factor;
  if (column.higher_is_better) json["higher_is_better"] = true;
  return json;
}

/// The table of a world without its name; default values are left out, to keep the page small.
Json table_json(const WorldEntry& entry) {
  const auto world = entry.make({}).world;
  const ScorePlace place = world->traits().score_place;
  const WorldFields& fields = *world->traits().fields;
  Json json = {{"unit", world->traits().unit},
               {"failure_score", world->traits().failure_score ? Json(*world->traits().failure_score) : Json(nullptr)},
               {"bound", bound_place_json(*world)},
               {"bound_meaning", fields.bound_meaning},
               {"columns", Json::array()}};
  for (const Column& column : fields.columns)
    if (!column.key.empty()) json["columns"].push_back(column_json(column));
  if (!place.inner.empty()) json["score"] = {{"key", place.key}, {"inner", place.inner}, {"unit", place.unit}};
  if (world->traits().rules_in_steps) json["in_steps"] = true;
  if (entry.records != nullptr && !residents_of(*world).empty()) json["plays"] = true;
  return json;
}

}  // namespace

Json world_tables_json() {
  Json list = Json::array();
  for (const WorldEntry* entry : all_worlds()) {
    Json table = table_json(*entry);
    Json names = {entry->name};
    const auto same = std::find_if(list.begin(), list.end(), [&](const Json& one) { return one["table"] == table; });
    if (same == list.end())
      list.push_back({{"names", std::move(names)}, {"table", std::move(table)}});
    else
      (*same)["names"].push_back(entry->name);
  }
  return list;
}

}  // namespace labmouse
