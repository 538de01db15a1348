// JSON in the lab: which of the library's types is which.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace labmouse {

/// JSON that is written: the fields of an object stay in the order in which they were added.
using Json = nlohmann::ordered_json;
/// JSON that was read: a field is found in a time that grows with the logarithm of their number, which a hostile file
/// chooses.
using ReadJson = nlohmann::json;

/// Whether lists and objects stand in each other deeper than anything that labmouse writes. Such a text is not to be
/// read: the library copies, compares and writes what it read by recursion, which a hostile file could make as deep as
/// it is long.
bool is_too_deep(std::string_view text);
inline constexpr int most_json_depth = 32;  // a race's JSON is 7 deep

/// The first number that a double cannot hold: 1e309, or 1e-320, which would be read as 0 or with few digits. Empty,
/// and at the end of the text, where there is none.
std::string_view bad_json_number(std::string_view text);

/// What a text of unknown origin says; discarded where it is no JSON, too deep, or has a number that a double cannot
/// hold: json_problem says which.
ReadJson read_json(std::string_view text);
/// The same, with the fields of objects in the order in which they stand there.
Json read_ordered_json(std::string_view text);

/// JSON in one line without spaces; what is no UTF-8 becomes U+FFFD.
std::string one_line(const Json& json);

}  // namespace labmouse
