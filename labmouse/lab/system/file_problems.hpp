// What the system says of a file, in words for users.
#pragma once

#include <string>

namespace labmouse {

/// Why the system refused, from its error number: "no space is left on the device".
std::string cause_of(int error_number);

}  // namespace labmouse
