#include "labmouse/external/talk.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace labmouse {
namespace {

using namespace std::chrono_literals;

constexpr const char* left_words = "it ended, but a process that it had started kept its output open";

/// Time for an external mouse to write files at its end.
constexpr auto grace = 250ms;

ForfeitReason reason_of(TreeLimit limit) {
  switch (limit) {
    case TreeLimit::processes:
      return ForfeitReason::too_many_processes;
    case TreeLimit::memory:
      return ForfeitReason::too_much_memory;
    case TreeLimit::written:
      return ForfeitReason::too_much_written;
    case TreeLimit::none:
      break;
  }
  return ForfeitReason::none;
}

}  // namespace

ExternalTalk::ExternalTalk(const Launch& launch, std::string_view greeting)
    : limits_(launch.limits),
      beginning_(launch.beginning),
      greeting_(greeting),
      contest_(launch.limits.contest),
      process_(launch) {
  if (!process_.error().empty()) give_up(ForfeitReason::not_started, process_.error());
}

ExternalTalk::~ExternalTalk() { process_.end(grace); }

std::optional<std::string_view> ExternalTalk::greet(std::string_view briefing) {
  if (reason_ != ForfeitReason::none) return std::nullopt;
  process_.send(briefing);
  return hear(limits_.start, limits_.contest);
}

std::optional<std::string_view> ExternalTalk::ask(std::string_view question) {
  if (reason_ != ForfeitReason::none) return std::nullopt;
  process_.send(question);
  if (process_.unsent() > limits_.most_unread) {
    give_up(ForfeitReason::flooded, fmt::format("it left more than {} bytes of replies unread", limits_.most_unread));
    return std::nullopt;
  }
  return hear(limits_.silence, limits_.decision);
}

std::optional<std::string_view> ExternalTalk::hear(std::chrono::milliseconds silence, std::chrono::nanoseconds work) {
  Patience patience(silence, work);
  for (;;) {
    const auto line = process_.lines().next();
    if (patience.is_overworked(process_)) {
      give_up(ForfeitReason::late,
              // Neither the time nor the answer, which may or may not be there: the same contest has the same words.
              fmt::format("it used more than {} of processor time for one answer ({})", seconds_text(work),
                          greeted_ ? "--decision-limit" : "--contest-limit"));
      return std::nullopt;
    }
    if (line) return line;
    if (process_.lines().too_long()) {
      give_up(too_long(limits_.longest_line, process_.lines().rest()));
      return std::nullopt;
    }
    const ExternalEvent event = patience.wait(process_, contest_);
    if (event == ExternalEvent::output || patience.is_overworked(process_)) continue;
    give_up(event, patience, silence);
    return std::nullopt;
  }
}

void ExternalTalk::give_up(ExternalEvent event, const Patience& patience, std::chrono::milliseconds silence) {
  switch (event) {
    case ExternalEvent::ended:
      return give_up(ended_early(describe(process_.status().value_or(ExitStatus())), greeted_, beginning_, greeting_));
    case ExternalEvent::left:
      return give_up(ForfeitReason::left, left_words);
    case ExternalEvent::closed:
      return give_up(ForfeitReason::closed, "it closed its standard output");
    case ExternalEvent::exceeded:
      return give_up(reason_of(process_.exceeded()),
                     "it and what it started " + describe(process_.exceeded(), limits_));
    case ExternalEvent::interrupted:
      return give_up(ForfeitReason::interrupted, "it was interrupted");
    case ExternalEvent::output:
    case ExternalEvent::timeout:
      break;
  }
  // Where the system does not list processes.
  if (process_.status()) return give_up(ForfeitReason::left, left_words);
  if (!contest_.is_judged() || !patience.is_judged())
    return give_up(ForfeitReason::not_judged, "the machine was too busy to tell whether it was slow");
  if (contest_.is_over(process_))
    return give_up(ForfeitReason::out_of_time,
                   fmt::format("its contest took longer than {} (--contest-limit)", seconds_text(limits_.contest)));
  if (process_.deaf()) return give_up(ForfeitReason::closed, "it closed its standard input");
  const std::string time =
      fmt::format("{} ({})", seconds_text(silence), greeted_ ? "--silence-limit" : "--start-limit");
  give_up(hung(time, greeted_, process_.lines().rest(), beginning_));
}

void ExternalTalk::give_up(ForfeitReason reason, std::string_view sentence) {
  if (reason_ != ForfeitReason::none) return;
  reason_ = reason;
  process_.end(0ms);
  last_words_ = last_words_of(sentence, process_.errors());
}

}  // namespace labmouse
