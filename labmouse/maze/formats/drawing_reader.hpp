// Reader of the drawing format. drawing.cpp explains the format and has the writer.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse::formats {

/// Whether a character stands for a post.
bool is_post(char letter);

/// The text with full stops in place of middle dots, which some programs draw for walls that were not seen.
std::string with_plain_dots(std::string_view content);

/// The maze of a drawing, or what is wrong with it.
ReadResult read_drawing(std::string_view content);

}  // namespace labmouse::formats
