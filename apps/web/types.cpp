// Prints the page's TypeScript types: what scripts/page-types writes into apps/web/page/src/core/types.ts.
#include <iostream>

#include "labmouse/lab/shapes/typescript.hpp"

int main() { std::cout << labmouse::page_typescript(); }
