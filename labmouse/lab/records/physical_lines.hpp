// What a record of the physical world has besides that of one in seconds: lines that are written, and read strictly.
#pragma once

#include <string>

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {

/// [x, y, heading]
Json pose_json(const Pose& pose);

/// Of the header: noise, its spread and groups, handling, and the speed of a search.
Json conditions_json(const PhysicalPart& part);
/// All decisions: [rotation, cells], "reset", or the reason of a forfeit.
Json actions_json(const std::vector<Action>& actions);
/// What the sensors said, what was touched, and the trace.
std::string physical_lines(const PhysicalNotes& notes);
/// Of the last line.
Json counts_json(const PhysicalNotes& notes);

// All of these give the fields what is wrong.

void read_conditions(const ReadJson& json, PhysicalPart& part, JsonFields& outer);
void read_actions_line(PhysicalNotes& notes, JsonFields& fields);
/// How a run ended.
RunEnd read_run_end(JsonFields& fields);
/// A line of what was seen, touched or traced; whether it is one.
bool read_physical_line(const ReadJson& json, Size size, PhysicalNotes& notes, JsonFields& fields);
void read_counts(const ReadJson& json, PhysicalNotes& notes, JsonFields& outer);

}  // namespace labmouse
