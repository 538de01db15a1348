// Strict reader of requests: it keeps the first error, and returns a valid default for a missing or wrong field.
#pragma once

#include <string>

#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {

/// Largest step budget of a contest, the same as on the command line.
inline constexpr int most_page_steps = 1'000'000;

/// The fields of a request. If error() is not empty, no value that it returned may be used.
class PageRequest : public JsonFields {
 public:
  explicit PageRequest(const ReadJson& json) : JsonFields(json, ""), request_(json) {}

  /// The unchanged request.
  const ReadJson& json() const { return request_; }
  /// The maze of a field.
  NamedMaze maze(const char* key = "maze");
  /// The same for a JSON value; error messages name its `path`.
  NamedMaze maze_at(const ReadJson& json, const std::string& path);
  /// `seed`: 0 to 2^64 - 1.
  std::uint64_t seed();
  /// The rules of steps: the defaults, overridden by `budget`, `search_factor` and `stride`.
  Rules rules();

 private:
  const ReadJson& request_;
};

}  // namespace labmouse
