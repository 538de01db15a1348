// The reasons of a mouse in words.
#pragma once

#include <string>

#include "labmouse/lab/records/record_file.hpp"

namespace labmouse {

/// Each choice of a record that has reasons, with so many of its candidates at most (at least 1), the best first, and
/// at the end why the search run stopped. Lines of 80 columns at most. Empty where the record has no reasons.
std::string explanation_of(const RecordFile& file, int candidates);

/// What a mouse went by in one choice, in a few words without their end: "the lowest score, of 7 candidates".
std::string ground_words(const Reasons& reasons);

}  // namespace labmouse
