// Prints the files that scripts/page-types writes into apps/web/page/src/core: the page's TypeScript types (types.ts),
// or with any argument the tables of score units and leaderboard columns of each world (worlds.json).
#include <cstdio>

#include "labmouse/lab/page/world_tables.hpp"
#include "labmouse/lab/shapes/typescript.hpp"

int main(int count, char**) {
  const std::string text = count > 1 ? labmouse::world_tables_json().dump(2) + "\n" : labmouse::page_typescript();
  std::fputs(text.c_str(), stdout);
}
