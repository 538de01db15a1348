// A file that says that somebody is at work beside it, whatever becomes of him.
#pragma once

#include <string>

#include "labmouse/lab/system/descriptor.hpp"

namespace labmouse {

/// The file, made where it is not there, open and locked until it is closed, or until this program ends. `error` is 0
/// then; EWOULDBLOCK where another has locked it, or another number where it cannot be made. Whoever removes the file
/// does so before it is closed.
Descriptor locked_file(const std::string& path, int& error);

}  // namespace labmouse
