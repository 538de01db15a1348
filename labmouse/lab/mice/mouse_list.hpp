// The mice for readers: all in a list, or one with all that there is to say of it.
#pragma once

#include <string>

#include "labmouse/lab/system/named_text.hpp"

namespace labmouse {

/// Each mouse in a line, and below it each of its parameters with its default, its range and its meaning.
std::string mouse_list();

/// One mouse: what it does, by which method, where the idea comes from, and its parameters.
NamedText mouse_sheet(const std::string& name);

}  // namespace labmouse
