#include "labmouse/lab/system/file_problems.hpp"

#include <cerrno>
#include <system_error>

namespace labmouse {

std::string cause_of(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return "no space left on the device";
#ifdef EDQUOT  // not on Windows
    case EDQUOT:
      return "the disk quota is exceeded";
#endif
    case EFBIG:
      return "the file would exceed the limit of `ulimit -f` or of the file system";
    case EROFS:
      return "the file system is read-only";
    case EACCES:
    case EPERM:
      return "permission denied";
    case ENOENT:
      return "no such folder";
    case ENOTDIR:
      return "part of the path is not a folder";
    case EISDIR:
      return "it is a folder";
    case ENAMETOOLONG:
      return "the name is too long";
    case ELOOP:
      return "its symbolic links form a loop";
    case EPIPE:
      return "its reader has closed it";
    case EBADF:
      return "it is not open";
    default:
      return std::generic_category().message(error_number);
  }
}

}  // namespace labmouse
