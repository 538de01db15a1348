// Reader of the drawing format. drawing.cpp explains the format and has the writer.
#pragma once

#include <string_view>

#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse::formats {

/// Whether a character stands for a post.
bool is_post(char letter);

/// The maze of a drawing, or what is wrong with it.
ReadResult read_drawing(std::string_view content);

}  // namespace labmouse::formats
