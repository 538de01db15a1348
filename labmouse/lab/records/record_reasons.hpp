// The reasons of a mouse in the lines of a record.
#pragma once

#include <string>

#include "labmouse/grid/cell.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/mouse/reasons.hpp"

namespace labmouse {

/// As docs/reference/records.md describes them.
Json reasons_json(const Reasons& reasons);

/// Reads them for a maze of that size; returns what is wrong, or nothing.
std::string read_reasons(const ReadJson& json, Size size, Reasons& reasons);

/// Whether a maze of that size has all their walls and cells.
bool fit(const Reasons& reasons, Size size);

}  // namespace labmouse
