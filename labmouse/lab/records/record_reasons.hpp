// JSON of the reasons of a mouse, in the lines of a record.
#pragma once

#include <string>

#include "labmouse/grid/cell.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/mouse/reasons.hpp"

namespace labmouse {

/// The JSON of reasons, as docs/reference/records.md describes it.
Json reasons_json(const Reasons& reasons);

/// Reads reasons for a maze of that size; returns what is wrong, or nothing.
std::string read_reasons(const ReadJson& json, Size size, Reasons& reasons);

/// Whether all walls and cells of the reasons are in a maze of that size.
bool fit(const Reasons& reasons, Size size);

}  // namespace labmouse
