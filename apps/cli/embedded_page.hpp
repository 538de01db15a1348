// The page that was built before this program was.
#pragma once

#include <string_view>

namespace labmouse::cli {

/// The HTML of the page; empty where there was none at the time of the build.
std::string_view embedded_page();

}  // namespace labmouse::cli
