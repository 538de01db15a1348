// Mice as tables call them.
#pragma once

#include <string>
#include <vector>

namespace labmouse {

/// The names, printable. Of commands, which can be long, only the end stands there, since it names the file, as long as
/// all names stay different.
std::vector<std::string> mouse_names(const std::vector<std::string>& specs);

}  // namespace labmouse
