// A mouse in Python, which is asked for one decision at a time.
#pragma once

#include <atomic>
#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "python_strategy.hpp"

namespace labmouse::python {

/// The mouse of one contest. It decides in another process where `elsewhere` of the maker is not None, and else in a
/// thread of its own: once `stop`, which may be null, is true, neither is waited for. Not with the interpreter's lock.
std::unique_ptr<DrivingStrategy> make_live_strategy(const std::shared_ptr<const MouseMaker>& maker,
                                                    const Briefing& briefing, const std::atomic<bool>* stop);

}  // namespace labmouse::python
