// The JSON types of the lab, and safe reading of JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace labmouse {

/// JSON to write: objects keep the order of their fields.
using Json = nlohmann::ordered_json;
/// JSON that was read. Finding a field takes logarithmic time, which matters for hostile files with many fields.
using ReadJson = nlohmann::json;

/// Whether lists and objects are nested deeper than labmouse ever writes. Do not parse such a text: the library copies,
/// compares and writes JSON by recursion, so a hostile file could overflow the stack.
bool is_too_deep(std::string_view text);
inline constexpr int most_json_depth = 32;  // a race's JSON is 7 deep

/// The first number that a double cannot hold: too large (1e309) or too small (1e-320, which would lose digits or
/// become 0). An empty view at the end of the text where there is none.
std::string_view bad_json_number(std::string_view text);

/// Parses a text of unknown origin. is_discarded() of the result is true where the text is no JSON, is nested too
/// deeply, or has a number that a double cannot hold; json_problem() tells which.
ReadJson read_json(std::string_view text);
/// The same, keeping the order of fields.
Json read_ordered_json(std::string_view text);

/// JSON in one line without spaces; invalid UTF-8 becomes U+FFFD.
std::string one_line(const Json& json);

}  // namespace labmouse
