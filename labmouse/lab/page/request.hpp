// What a call is asked, read strictly: what is missing or wrong is remembered, and a value in range stands in its
// place.
#pragma once

#include <string>

#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {

/// A contest in the page has no more steps than this, as one of the command line.
inline constexpr int most_page_steps = 1'000'000;

/// The fields of a request. Where its error is not empty, nothing that it gave may be used.
class PageRequest : public JsonFields {
 public:
  explicit PageRequest(const ReadJson& json) : JsonFields(json, ""), request_(json) {}

  /// The request as it came.
  const ReadJson& json() const { return request_; }
  /// The maze in the field `maze`, or in another one.
  NamedMaze maze(const char* key = "maze");
  /// The same for a value that stands at that path.
  NamedMaze maze_at(const ReadJson& json, const std::string& path);
  /// `seed`: 0 to 2^64 - 1.
  std::uint64_t seed();
  /// The rules of the capstone, with `budget`, `search_factor` and `stride` where they are given.
  Rules rules();

 private:
  const ReadJson& request_;
};

}  // namespace labmouse
