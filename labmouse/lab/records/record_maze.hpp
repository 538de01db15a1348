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

/// Reads the maze of a header, which has a drawing; where it does not say start, heading or goals, the drawing does. On
/// failure the fields hold the error.
std::optional<Maze> read_record_maze(JsonFields& fields);

/// A line of a record: the object and a line feed. Text from outside may be no UTF-8: what is none is replaced.
std::string record_line(const Json& json);

}  // namespace labmouse
