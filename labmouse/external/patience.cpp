#include "labmouse/external/patience.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace labmouse {
namespace {

using namespace std::chrono_literals;

/// Interval of measurements of a mouse that does not answer. The shortest limits the effort; the longest is small
/// because the state at a measurement stands for the time before it.
constexpr std::chrono::milliseconds shortest_pause{20}, longest_pause{200};

/// Unclassified time may be this many times the limit, and at least `least_unknown`.
constexpr int most_unknown = 10;
constexpr std::chrono::milliseconds least_unknown{250};
/// Real time may be this many times the limit, and at least `least_by_the_clock`.
constexpr int most_by_the_clock = 30;
constexpr std::chrono::seconds least_by_the_clock{5};

std::chrono::nanoseconds positive(std::chrono::nanoseconds time) { return std::max(time, 0ns); }

}  // namespace

std::string seconds_text(Patience::Clock::duration time) {
  return fmt::format("{:.3g} s", std::chrono::duration<double>(time).count());
}

void OwnTime::advance(ExternalProcess& process) {
  const Look now = look(process);
  const auto known = positive(now.tree.worked - last_.tree.worked) + positive(now.tree.waited - last_.tree.waited) +
                     positive(now.host_waited - last_.host_waited);
  (now.tree.is_busy ? unknown_ : idle_) += positive(now.at - last_.at - known);
  last_ = now;
}

ContestClock::Clock::duration ContestClock::pause(Clock::duration passed) const {
  return std::clamp<Clock::duration>((limit_ - passed) / 4, shortest_pause, 1s);
}

void ContestClock::add(Clock::duration waited, std::chrono::nanoseconds idle, std::chrono::nanoseconds unknown) {
  waited_ += waited;
  idle_ += idle;
  unknown_ += unknown;
}

ContestClock::Clock::duration ContestClock::passed(const TreeTime& tree) const {
  if (tree.worked_before > 0ns) return tree.worked + idle_;
  // Without measurements, the rest of the waiting time counts as idle.
  const auto host_waited = waited_for_processor() - host_waited_;
  return tree.worked + std::max(idle_, positive(waited_ - tree.worked - tree.waited - host_waited - unknown_));
}

bool ContestClock::is_over(ExternalProcess& process) {
  const auto now = Clock::now();
  if (is_over_ || now < next_look_) return is_over_;
  const Clock::duration own = passed(process.tree_time());
  is_over_ = own > limit_;
  is_judged_ = is_over_ || (waited_ <= std::max<Clock::duration>(most_by_the_clock * limit_, least_by_the_clock) &&
                            unknown_ <= std::max<Clock::duration>(most_unknown * limit_, least_unknown));
  is_over_ = is_over_ || !is_judged_;
  next_look_ = now + pause(own);
  return is_over_;
}

Patience::Patience(Clock::duration silence, std::chrono::nanoseconds work)
    : silence_(silence), work_(work), next_look_(Clock::now() + shortest_pause) {}

Patience::Clock::duration Patience::pause() const {
  const Clock::duration left = std::min<Clock::duration>(work_ - worked_, silence_ - time_->passed());
  return std::clamp<Clock::duration>(left / 2, shortest_pause, longest_pause);
}

bool Patience::is_judged() const {
  return !time_ || time_->passed() > silence_ ||
         time_->unknown() <= std::max<Clock::duration>(most_unknown * silence_, least_unknown);
}

bool Patience::is_over() const { return worked_ > work_ || !is_judged() || (time_ && time_->passed() > silence_); }

void Patience::look(ExternalProcess& process, ContestClock& contest) {
  if (!time_) {
    before_ = process.processor_time();
    time_.emplace(process);
  } else {
    const auto idle = time_->idle(), unknown = time_->unknown();
    time_->advance(process);
    contest.add(0ns, time_->idle() - idle, time_->unknown() - unknown);
    worked_ = process.processor_time() - before_;
  }
  next_look_ = Clock::now() + pause();
}

ExternalEvent Patience::wait(ExternalProcess& process, ContestClock& contest) {
  for (;;) {
    if (is_over() || contest.is_over(process)) return ExternalEvent::timeout;
    const auto begin = Clock::now();
    const ExternalEvent event = process.wait(next_look_);
    const auto end = Clock::now();
    contest.add(end - begin, 0ns, 0ns);
    if (end >= next_look_) look(process, contest);
    if (event != ExternalEvent::timeout) return event;
  }
}

bool Patience::is_overworked(ExternalProcess& process) {
  if (time_) worked_ = process.processor_time() - before_;
  return worked_ > work_;
}

}  // namespace labmouse
