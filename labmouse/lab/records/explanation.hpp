// The reasons behind a mouse's choices, in words.
#pragma once

#include <string>

#include "labmouse/lab/records/record_file.hpp"

namespace labmouse {

/// Lists each choice with recorded reasons, with its `candidates` best candidates (at least 1), and then why the search
/// run stopped. Lines have at most 80 columns. Empty where the record has no reasons.
std::string explanation_of(const RecordFile& file, int candidates);

/// How a mouse made one choice, in a few words without a full stop: "the lowest score, of 7 candidates".
std::string ground_words(const Reasons& reasons);

}  // namespace labmouse
