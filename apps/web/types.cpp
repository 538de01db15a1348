// Prints the page's TypeScript types: what scripts/page-types writes into apps/web/page/src/core/types.ts.
#include <cstdio>

#include "labmouse/lab/shapes/typescript.hpp"

int main() { std::fputs(labmouse::page_typescript().c_str(), stdout); }
