// The browser page that is embedded in this program.
#pragma once

#include <string_view>

namespace labmouse::cli {

/// The HTML of the page; empty if it did not exist when the program was built.
std::string_view embedded_page();

}  // namespace labmouse::cli
