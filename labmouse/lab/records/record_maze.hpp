// The maze in the header of a record.
#pragma once

#include <optional>
#include <string>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// Name, start, heading, goals and drawing, as docs/reference/records.md lists them.
Json record_maze_json(const std::string& name, const Maze& maze);

/// Reads the maze of a header, which must have a drawing. A missing start, heading or goal list is taken from the
/// drawing. On failure `fields` holds the error.
std::optional<Maze> read_record_maze(JsonFields& fields);

/// A line of a record: the object and a line feed. Invalid UTF-8 is replaced.
std::string record_line(const Json& json);

}  // namespace labmouse
