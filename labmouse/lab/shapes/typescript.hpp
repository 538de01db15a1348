// The shapes of the page in the words of its own language.
#pragma once

#include <string>

namespace labmouse {

/// apps/web/page/src/core/types.ts: all named shapes, and the calls as an interface.
std::string page_typescript();

}  // namespace labmouse
