#include "labmouse/lab/system/file_lock.hpp"

#include <cerrno>

namespace labmouse {

Descriptor locked_file(const std::string& path, int& error) {
  while (true) {
    Descriptor file = Descriptor::opened(open_lock(path));
    error = file.number() < 0 ? errno : lock_file(file.number());
    // Its previous owner may have removed it meanwhile; the lock of a removed file is useless, so try again.
    if (error != 0 || has_name(file.number())) return file;
  }
}

}  // namespace labmouse
