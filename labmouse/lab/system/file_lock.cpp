#include "labmouse/lab/system/file_lock.hpp"

#include <cerrno>

namespace labmouse {

Descriptor locked_file(const std::string& path, int& error) {
  while (true) {
    Descriptor file = Descriptor::opened(open_lock(path));
    error = file.number() < 0 ? errno : lock_file(file.number());
    // Whoever had it before may have removed it in between, and then it locks nothing.
    if (error != 0 || has_name(file.number())) return file;
  }
}

}  // namespace labmouse
