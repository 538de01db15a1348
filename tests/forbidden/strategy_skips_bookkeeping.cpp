// module: strategies
// error: overriding final|overrides a 'final' function
//
// A strategy on top of Explorer decides in explore(); what decide() does around it cannot be left out.
#include "labmouse/mouse/explorer.hpp"

namespace labmouse {

class Hasty final : public Explorer {
 public:
  using Explorer::Explorer;

#ifndef LABMOUSE_ALLOWED
  Action decide(const Sighting&) override { return Action::reset(); }
#endif

 private:
  Action explore() override { return Action::reset(); }
};

}  // namespace labmouse
