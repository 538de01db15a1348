// Writes and strictly reads the lines that only records of the physical world and of the failure model have, besides
// those of all records in seconds.
#pragma once

#include <string>

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {

/// [x, y, heading]
Json pose_json(const Pose& pose);

/// Part of the header: the edition of the world, the conditions of the contest and, in the failure model, the name and
/// hash of its failure rates.
Json conditions_json(const PhysicalPart& part);
/// All decisions of a strategy: [rotation, cells], "reset", or the reason of a forfeit. For an external controller:
/// instead, the PWM duties of both motors and the commands that it gave in each tick.
std::string decision_lines(const PhysicalNotes& notes);
/// The evidence for walls that the sensors gave (log-odds), the contacts with walls, and the trace.
std::string physical_lines(const PhysicalNotes& notes);
/// Part of the last line: counts over the whole contest, and the severity of its random draws.
Json counts_json(const PhysicalNotes& notes);

/// Why a contest under these conditions is too long to be recorded, and what to do; empty if it is not too long.
std::string why_not_driven(const PhysicalConditions& conditions, MazeTime time_limit);

// All of these functions report errors to their JsonFields.

void read_conditions(const ReadJson& json, PhysicalPart& part, JsonFields& outer);
/// Reads a line of decisions; returns false if it is another kind of line.
bool read_decision_line(const ReadJson& json, PhysicalNotes& notes, JsonFields& fields);
/// How a run ended.
RunEnd read_run_end(JsonFields& fields);
/// Reads a line of wall evidence, a contact or a point of the trace; returns false if it is another kind of line.
bool read_physical_line(const ReadJson& json, Size size, std::size_t sensors, PhysicalNotes& notes, JsonFields& fields);
void read_counts(const ReadJson& json, PhysicalNotes& notes, JsonFields& outer);

}  // namespace labmouse
