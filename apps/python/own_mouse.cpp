#include "own_mouse.hpp"

#include <memory>
#include <utility>

#include "live_strategy.hpp"

namespace labmouse::python {

Contestant python_contestant(OwnMouse own, const std::atomic<bool>* stop) {
  Contestant mouse;
  mouse.name = own.name;
  // Otherwise its name would count as its SPEC, and may be that of a built-in mouse.
  mouse.spec = "python";
  mouse.uses_chance = own.uses_chance;
  mouse.identity = [identity = own.identity] { return identity; };
  const auto maker = std::make_shared<const MouseMaker>(std::move(own.maker), std::move(own.elsewhere));
  const auto make = [maker, stop](const Maze&, const Briefing& briefing) {
    return make_live_strategy(maker, briefing, stop);
  };
  mouse.kind = Decider{make, make};
  return mouse;
}

}  // namespace labmouse::python
