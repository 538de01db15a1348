// module: mouse
// error: discards qualifiers|not marked const
//
// Knowledge only grows: nobody closes again what was seen open.
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

void forget(Knowledge& knowledge, Wall wall) {
#ifdef LABMOUSE_ALLOWED
  WallSet copy = knowledge.open();
  copy.erase(wall);
#else
  knowledge.open().erase(wall);
#endif
}

}  // namespace labmouse
