// module: strategies
// error: is private within this context|is a private member
//
// A strategy does not set its own pose: it follows from the actions.
#include "labmouse/mouse/explorer.hpp"

namespace labmouse {

class Ghost final : public Explorer {
 public:
  using Explorer::Explorer;

 private:
  Action explore() override {
#ifndef LABMOUSE_ALLOWED
    pose_ = briefing().start;
#endif
    return Action::reset();
  }
};

}  // namespace labmouse
