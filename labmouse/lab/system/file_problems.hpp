// Error numbers of file operations in words for users.
#pragma once

#include <string>

namespace labmouse {

/// The cause of an error number: "no space left on the device".
std::string cause_of(int error_number);

}  // namespace labmouse
