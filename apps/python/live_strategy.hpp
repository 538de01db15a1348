// A mouse in Python that the contest asks for one decision at a time, in a thread or process of its own.
#pragma once

#include <atomic>
#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "python_strategy.hpp"

namespace labmouse::python {

/// Makes the mouse of one contest. It decides in another process if the maker's `elsewhere` is not None, and otherwise
/// in a thread of its own. Once `stop` (may be null) is true, a call interrupts the thread and, if the mouse still does
/// not answer, abandons it; a process is killed by labmouse._workers.Workers. Call without the GIL.
std::unique_ptr<DrivingStrategy> make_live_strategy(const std::shared_ptr<const MouseMaker>& maker,
                                                    const Briefing& briefing, const std::atomic<bool>* stop);

}  // namespace labmouse::python
