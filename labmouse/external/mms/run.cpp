#include "labmouse/external/mms/run.hpp"

#include <fmt/format.h>

#include <csignal>

#include "labmouse/external/mms/loop.hpp"
#include "labmouse/external/patience.hpp"
#include "labmouse/external/process.hpp"
#include "labmouse/external/quoted_line.hpp"

namespace labmouse {
namespace {

using Clock = ExternalProcess::Clock;
using namespace std::chrono_literals;

MmsOutcome outcome_of(TreeLimit limit) {
  if (limit == TreeLimit::processes) return MmsOutcome::too_many_processes;
  return limit == TreeLimit::memory ? MmsOutcome::too_much_memory : MmsOutcome::too_much_written;
}

/// One program with its simulator and its time limits.
class Hosting {
 public:
  using Listener = std::function<void(const MmsEvent&, const MmsHost&)>;

  Hosting(const Launch& launch, const Maze& maze, const MmsOptions& options, const Listener& listener)
      : launch_(launch),
        options_(options),
        host_(maze, options),
        begin_(Clock::now()),
        contest_(launch.limits.contest),
        patience_(launch.limits.start, launch.limits.start),
        external_(launch) {
    if (!listener) return;
    host_.on_event([this, listener](const MmsEvent& event) {
      const auto called = Clock::now();
      listener(event, host_);
      told_ += Clock::now() - called;
    });
  }

  MmsRun hold() {
    if (!external_.error().empty())
      finish(MmsOutcome::not_started, external_.error());
    else
      while (!ended_) take(patience_.wait(external_, contest_));
    run_.seconds = std::chrono::duration<double>(Clock::now() - begin_ - told_).count();
    // Errors that a program writes because it is ended would hide its earlier ones.
    run_.errors = external_.errors();
    external_.end(0ms);
    if (ended_itself()) run_.errors = external_.errors();
    return taken_down();
  }

 private:
  void take(ExternalEvent event) {
    obey_lines();
    if (ended_) return;
    switch (event) {
      case ExternalEvent::output:
        return;
      case ExternalEvent::ended:
        return finish_ended();
      case ExternalEvent::timeout:
        if (!external_.status()) return finish_late();
        [[fallthrough]];  // where the system does not list processes
      case ExternalEvent::left:
        return finish(MmsOutcome::left,
                      describe(*external_.status()) + ", but a process that it started is still running");
      case ExternalEvent::closed:
        return finish(MmsOutcome::closed, "closed its standard output and kept running");
      case ExternalEvent::exceeded:
        return finish(outcome_of(external_.exceeded()),
                      "it and what it started " + describe(external_.exceeded(), launch_.limits));
      case ExternalEvent::interrupted:
        return finish(MmsOutcome::interrupted, "by its user");
    }
  }

  /// Obeys the lines received so far, and sends all replies at once.
  void obey_lines() {
    const std::size_t unsent = external_.unsent();
    const std::int64_t lines = host_.lines();
    replies_.clear();
    while (host_.goes_on()) {
      const auto line = external_.lines().next();
      if (!line) break;
      const std::size_t replied = replies_.size();
      host_.obey(*line, replies_);
      if (replies_.size() > replied) trail_.add(*line, host_.lines(), host_.pose());
    }
    if (!replies_.empty()) external_.send(replies_);
    // A complete line, or a reply that was read, restarts the time limits; bytes of an incomplete line do not.
    if (host_.lines() > lines || unsent < unsent_) patience_ = {launch_.limits.silence, launch_.limits.decision};
    unsent_ = external_.unsent();
    judge_lines();
  }

  void judge_lines() {
    const ExternalLimits& limits = launch_.limits;
    if (!host_.goes_on() && host_.waits())
      finish(MmsOutcome::waiting, fmt::format("waits for Reset, which was pressed {} times", options_.presses));
    else if (host_.is_endless())
      finish_never_ended(host_.lines() >= options_.most_lines
                             ? fmt::format("{} lines (--line-limit)", options_.most_lines)
                             : fmt::format("{} s in mms (--simulated-limit)", options_.most_seconds));
    else if (!host_.goes_on())
      finish(MmsOutcome::invalid, host_.log().empty() ? "an invalid line" : host_.log().back());
    else if (external_.lines().too_long())
      finish(MmsOutcome::flooded, fmt::format("wrote a line of more than {} bytes", limits.longest_line));
    else if (unsent_ > limits.most_unread)
      finish(MmsOutcome::flooded, fmt::format("left more than {} bytes of replies unread", limits.most_unread));
    else if (contest_.is_over(external_))
      finish_late();
  }

  bool ended_itself() const { return run_.outcome == MmsOutcome::complete || run_.outcome == MmsOutcome::failed; }

  void finish_ended() {
    const ExitStatus status = *external_.status();
    if (status.signal == SIGXCPU)
      return finish_never_ended(fmt::format("{} s of processor time (--cpu)", launch_.limits.processor_seconds));
    finish(status == ExitStatus{} ? MmsOutcome::complete : MmsOutcome::failed, describe(status));
  }

  void finish_late() {
    const ExternalLimits& limits = launch_.limits;
    if (!contest_.is_judged() || !patience_.is_judged())
      finish(MmsOutcome::not_judged, "the machine was too busy to tell whether it was slow");
    else if (contest_.is_over(external_))
      finish_never_ended(fmt::format("{} of its own time (--contest-limit)", seconds_text(limits.contest)));
    else
      finish(MmsOutcome::hung, said_nothing());
  }

  void finish_never_ended(std::string_view limit) {
    finish(MmsOutcome::never_ended, fmt::format("had not ended after {}; {}", limit, loop_text(trail_, host_.lines())));
  }

  std::string said_nothing() {
    const bool begun = host_.lines() > 0;
    if (patience_.is_overworked(external_))
      return fmt::format("used more than {} of processor time without a line ({})",
                         seconds_text(begun ? launch_.limits.decision : launch_.limits.start),
                         begun ? "--decision-limit" : "--start-limit");
    if (begun)
      return fmt::format("wrote no line for {} (--silence-limit){}", seconds_text(launch_.limits.silence), hint());
    return fmt::format("wrote no line within {} of starting (--start-limit){}", seconds_text(launch_.limits.start),
                       hint());
  }

  /// Possible cause of a missing line, for the message.
  std::string hint() {
    if (external_.deaf()) return "; it had closed its standard input";
    const std::string_view begun = external_.lines().rest();
    if (!begun.empty()) return fmt::format("; it wrote {} without ending the line", quoted_line(begun));
    return host_.lines() == 0 ? "; does it flush after each line?" : "";
  }

  void finish(MmsOutcome outcome, std::string end) {
    run_.outcome = outcome;
    run_.end = std::move(end);
    ended_ = true;
  }

  MmsRun taken_down() {
    run_.statistics = counted_statistics(host_.ledger(), run_.outcome);
    run_.pose = host_.pose();
    run_.canvas = host_.canvas();
    run_.clock = host_.clock();
    run_.lines = host_.lines();
    run_.invalid_lines = host_.invalid_lines();
    run_.log.assign(host_.log().begin(), host_.log().end());
    return std::move(run_);
  }

  const Launch& launch_;
  MmsOptions options_;
  MmsHost host_;
  Clock::time_point begin_;
  ContestClock contest_;
  Patience patience_;
  Clock::duration told_{};  ///< time that the listener took
  ExternalProcess external_;
  MmsTrail trail_;
  std::string replies_;
  std::size_t unsent_ = 0;  ///< unsent bytes of replies after the last call
  MmsRun run_;
  bool ended_ = false;
};

}  // namespace

MmsRun run_mms(const Launch& launch, const Maze& maze, const MmsOptions& options,
               const std::function<void(const MmsEvent&, const MmsHost&)>& listener) {
  return Hosting(launch, maze, options, listener).hold();
}

}  // namespace labmouse
