#include "labmouse/guests/patience.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace labmouse {
namespace {

using namespace std::chrono_literals;

/// How often a mouse that does not answer is looked at: at most, since it may work on many processors; and at least,
/// since what it does at that moment stands for the time before.
constexpr std::chrono::milliseconds shortest_pause{20}, longest_pause{200};

}  // namespace

std::string seconds_text(Patience::Clock::duration time) {
  return fmt::format("{:.3g} s", std::chrono::duration<double>(time).count());
}

void OwnTime::advance(GuestProcess& process) {
  const Look now = look(process);
  const auto since = [](std::chrono::nanoseconds before, std::chrono::nanoseconds after) {
    return std::max(after - before, 0ns);
  };
  if (!now.tree.is_busy)
    idle_ += since(since(last_.tree.worked, now.tree.worked) + since(last_.tree.waited, now.tree.waited) +
                       since(last_.host_waited, now.host_waited),
                   now.at - last_.at);
  last_ = now;
}

ContestClock::Clock::duration ContestClock::pause(Clock::duration passed) const {
  return std::clamp<Clock::duration>((limit_ - passed) / 4, shortest_pause, 1s);
}

void ContestClock::add(Clock::duration waited, std::chrono::nanoseconds idle) {
  waited_ += waited;
  idle_ += idle;
}

bool ContestClock::is_over(GuestProcess& process) {
  const auto now = Clock::now();
  if (is_over_ || now < next_look_) return is_over_;
  const TreeTime tree = process.tree_time();
  const Clock::duration passed = tree.worked + idle_;
  is_judged_ = waited_ <= most_by_the_clock * limit_ || passed > limit_;
  is_over_ = passed > limit_ || !is_judged_;
  next_look_ = now + pause(passed);
  return is_over_;
}

Patience::Clock::duration Patience::pause() const {
  if (!time_) return shortest_pause;
  const Clock::duration left = std::min<Clock::duration>(work_ - worked_, silence_ - time_->passed());
  return std::clamp<Clock::duration>(left / 2, shortest_pause, longest_pause);
}

GuestEvent Patience::wait(GuestProcess& process, ContestClock& contest) {
  for (;;) {
    if (contest.is_over(process)) return GuestEvent::timeout;
    const auto begin = Clock::now();
    const GuestEvent event = process.wait(begin + pause());
    const auto idle = time_ ? time_->idle() : 0ns;
    if (event == GuestEvent::timeout && time_) time_->advance(process);
    contest.add(Clock::now() - begin, (time_ ? time_->idle() : 0ns) - idle);
    if (event != GuestEvent::timeout) return event;
    if (!time_) {
      before_ = process.processor_time();
      time_.emplace(process);
    }
    if (is_overworked(process) || time_->passed() > silence_) return event;
    is_judged_ = Clock::now() - begin_ <= most_by_the_clock * silence_;
    if (!is_judged_) return event;
  }
}

bool Patience::is_overworked(GuestProcess& process) {
  if (time_) worked_ = process.processor_time() - before_;
  return worked_ > work_;
}

}  // namespace labmouse
