// module: strategies
// error: discards qualifiers|not marked const
//
// A strategy reads its knowledge; only readings add to it.
#include "labmouse/mouse/explorer.hpp"

namespace labmouse {

class Dreamer final : public Explorer {
 public:
  using Explorer::Explorer;

 private:
  Action explore() override {
#ifdef LABMOUSE_ALLOWED
    const bool open = knowledge().open().contains(wall_at(pose().cell, pose().heading));
#else
    const bool open = knowledge().learn(pose(), {3, 3, 3});
#endif
    return Action::step(0, open ? 1 : 0);
  }
};

}  // namespace labmouse
