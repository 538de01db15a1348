// Generates TypeScript types from the shapes.
#pragma once

#include <string>

namespace labmouse {

/// The text of apps/web/page/src/core/types.ts: all named shapes, and the calls as an interface.
std::string page_typescript();

}  // namespace labmouse
