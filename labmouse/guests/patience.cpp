#include "labmouse/guests/patience.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace labmouse {
namespace {

/// How often a guest that does not answer is looked at, at most: it may work on many processors.
constexpr std::chrono::milliseconds work_glance{20};

}  // namespace

std::string seconds_text(Patience::Clock::duration time) {
  return fmt::format("{:.3g} s", std::chrono::duration<double>(time).count());
}

GuestEvent Patience::wait(GuestProcess& process, Clock::time_point contest_end) {
  const auto until = std::min(begin_ + silence_, contest_end);
  for (;;) {
    const Clock::duration pause = counts_ ? std::max<Clock::duration>((work_ - worked_) / 2, work_glance) : work_glance;
    const GuestEvent event = process.wait(std::min(until, Clock::now() + pause));
    if (event != GuestEvent::timeout || Clock::now() >= until) return event;
    if (!counts_) before_ = process.processor_time();
    counts_ = true;
    if (is_overworked(process)) return event;
  }
}

bool Patience::is_overworked(GuestProcess& process) {
  if (counts_) worked_ = process.processor_time() - before_;
  return worked_ > work_;
}

}  // namespace labmouse
