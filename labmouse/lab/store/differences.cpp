#include "labmouse/lab/store/differences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

/// Differences that are named; the others become "...".
constexpr std::size_t most_words = 2;
/// Depth of nested objects to compare. Conditions have no more; a file from elsewhere may.
constexpr int most_depth = 3;

ReadJson member_of(const ReadJson& json, const std::string& key) { return json.value(key, ReadJson()); }

bool all_objects(const std::vector<ReadJson>& all) {
  return std::all_of(all.begin(), all.end(), [](const ReadJson& json) { return json.is_object(); });
}

bool differ(const std::vector<ReadJson>& all) {
  return std::adjacent_find(all.begin(), all.end(), std::not_equal_to<>()) != all.end();
}

std::string written(const ReadJson& value) {
  if (value.is_structured()) return "{...}";
  return value.is_string() ? value.get<std::string>() : value.is_null() ? "none" : value.dump();
}

std::vector<ReadJson> members(const std::vector<ReadJson>& all, const std::string& key) {
  std::vector<ReadJson> values;
  for (const ReadJson& json : all) values.push_back(member_of(json, key));
  return values;
}

/// Adds the differences at and below these objects to the words of each. `path` is a prefix such as "robot ".
void compare(const std::vector<ReadJson>& all, const std::string& path, int depth,
             std::vector<std::vector<std::string>>& words) {
  std::set<std::string> keys;
  for (const ReadJson& json : all)
    for (const auto& [key, value] : json.items()) keys.insert(key);
  const auto add = [&](const std::string& name, const std::vector<ReadJson>& values) {
    for (std::size_t i = 0; i < all.size(); ++i) words[i].push_back(name + written(values[i]));
  };
  if (keys.contains("name") && differ(members(all, "name"))) return add(path, members(all, "name"));
  for (const std::string& key : keys) {
    const std::vector<ReadJson> values = members(all, key);
    if (!differ(values)) continue;
    // The key "parameters" is left out of the path: only its members are informative.
    const std::string inner = key == "parameters" ? path : path + key + " ";
    if (all_objects(values) && depth < most_depth)
      compare(values, inner, depth + 1, words);
    else
      add(inner, values);
  }
}

}  // namespace

std::vector<std::string> differences_of(std::span<const std::string> conditions) {
  std::vector<std::string> told(conditions.size());
  std::vector<ReadJson> all;
  for (const std::string& text : conditions) all.push_back(read_json(text));
  if (!all_objects(all)) return told;
  // "tables" is only a hash of the other members.
  for (ReadJson& json : all) json.erase("tables");
  std::vector<std::vector<std::string>> words(all.size());
  compare(all, "", 1, words);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool more = words[i].size() > most_words;
    if (more) words[i].resize(most_words);
    told[i] = fmt::format("{}{}", fmt::join(words[i], ", "), more ? ", ..." : "");
  }
  return told;
}

}  // namespace labmouse
