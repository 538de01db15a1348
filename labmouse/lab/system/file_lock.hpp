// A lock file protects a folder or file. It is locked while a program writes there, and unlocked when the program ends
// for any reason.
#pragma once

#include <string>

#include "labmouse/lab/system/descriptor.hpp"

namespace labmouse {

/// Opens and locks a file, and creates it if needed. It stays locked until it is closed or the program ends. `error` is
/// 0 on success, EWOULDBLOCK where another program has locked it, or another error number. Remove the file before
/// closing it.
Descriptor locked_file(const std::string& path, int& error);

}  // namespace labmouse
