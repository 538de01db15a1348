// What a record of the physical world has besides that of one in seconds: lines that are written, and read strictly.
#pragma once

#include <string>

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {

/// [x, y, heading]
Json pose_json(const Pose& pose);

/// Of the header: the edition, and under which conditions and by whose dice the contest was run.
Json conditions_json(const PhysicalPart& part);
/// All decisions of a strategy: [rotation, cells], "reset", or the reason of a forfeit. Of a program of somebody else's
/// in place of these the duties that it gave, tick by tick.
std::string decision_lines(const PhysicalNotes& notes);
/// What the sensors said, what was touched, and the trace.
std::string physical_lines(const PhysicalNotes& notes);
/// Of the last line.
Json counts_json(const PhysicalNotes& notes);

/// Why a contest under these conditions is too long to be driven for its record, with what to do; empty where it is
/// not.
std::string why_not_driven(const PhysicalConditions& conditions, MazeTime time_limit);

// All of these give the fields what is wrong.

void read_conditions(const ReadJson& json, PhysicalPart& part, JsonFields& outer);
/// A line of decisions; whether it is one.
bool read_decision_line(const ReadJson& json, PhysicalNotes& notes, JsonFields& fields);
/// How a run ended.
RunEnd read_run_end(JsonFields& fields);
/// A line of what was seen, touched or traced; whether it is one.
bool read_physical_line(const ReadJson& json, Size size, PhysicalNotes& notes, JsonFields& fields);
void read_counts(const ReadJson& json, PhysicalNotes& notes, JsonFields& outer);

}  // namespace labmouse
