#include "labmouse/mouse/legs.hpp"

#include <algorithm>
#include <cassert>

namespace labmouse {

void join_legs(const Path& first, const Path& second, Path& joined) {
  assert(!first.empty() && !second.empty() && first.front() == second.front() && first.back() == second.back());
  joined.clear();
  joined.push_back(first.front());
  auto a = first.begin(), b = second.begin();
  for (auto next_a = a + 1; next_a != first.end(); ++next_a) {
    const auto next_b = std::find(b + 1, second.end(), *next_a);
    if (next_b == second.end()) continue;
    if (next_a - a <= next_b - b)
      joined.insert(joined.end(), a + 1, next_a + 1);
    else
      joined.insert(joined.end(), b + 1, next_b + 1);
    a = next_a;
    b = next_b;
    if (b + 1 == second.end()) return;
  }
}

}  // namespace labmouse
