#include "labmouse/lab/system/file_problems.hpp"

#include <cerrno>
#include <system_error>

namespace labmouse {

std::string cause_of(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return "no space is left on the device";
    case EDQUOT:
      return "the disk quota is used up";
    case EFBIG:
      return "the file would be larger than `ulimit -f` or the file system allows";
    case EROFS:
      return "the file system is read-only";
    case EACCES:
    case EPERM:
      return "permission denied";
    case ENOENT:
      return "no such folder";
    case ENOTDIR:
      return "a part of the path is not a folder";
    case EISDIR:
      return "it is a folder";
    case ENAMETOOLONG:
      return "the name is too long";
    case ELOOP:
      return "its symbolic links lead in a circle";
    case EPIPE:
      return "its reader has gone";
    case EBADF:
      return "it is not open";
    default:
      return std::generic_category().message(error_number);
  }
}

}  // namespace labmouse
