// The page of labmouse, for commands that write it.
#pragma once

#include <string>

namespace labmouse::cli {

/// The page in the file of --page, or else the embedded one where `path` is empty. Throws UsageError where there is
/// none.
std::string find_page(const std::string& path);

}  // namespace labmouse::cli
