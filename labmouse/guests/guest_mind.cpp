#include "labmouse/guests/guest_mind.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/guests/patience.hpp"
#include "labmouse/guests/protocol.hpp"
#include "labmouse/guests/quoted_line.hpp"

namespace labmouse {
namespace {

using namespace std::chrono_literals;

/// At its end a guest may still put something down.
constexpr auto grace = 250ms;

/// A text without the ends of its last lines.
std::string_view without_end(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

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

GuestMind::GuestMind(const Launch& launch, const Briefing& briefing)
    : limits_(launch.limits),
      beginning_(launch.beginning),
      knowledge_(briefing.size),
      contest_end_(Clock::now() + launch.limits.contest),
      process_(launch) {
  if (!process_.error().empty()) {
    give_up(ForfeitReason::not_started, process_.error());
    return;
  }
  process_.send(briefing_text(briefing));
  greet();
}

GuestMind::~GuestMind() { process_.end(grace); }

Action GuestMind::decide(const Sighting& seen) {
  if (reason_ != ForfeitReason::none) return Action::forfeit(reason_);
  process_.send(question(seen));
  const auto line = hear(limits_.silence, limits_.decision);
  if (!line) return Action::forfeit(reason_);
  const auto action = read_answer(*line);
  if (!action) {
    give_up(
        ForfeitReason::rubbish,
        fmt::format("it answered {} instead of `move ROTATION MOVEMENT`, `reset` or `forfeit`", quoted_line(*line)));
    return Action::forfeit(reason_);
  }
  if (const auto more = process_.lines().rest(); !more.empty()) {
    give_up(ForfeitReason::flooded, fmt::format("after its answer {} it wrote more: {}", quoted_line(*line),
                                                quoted_line(more.substr(0, more.find('\n')))));
    return Action::forfeit(reason_);
  }
  if (action->kind == Action::Kind::forfeit) give_up(action->reason, "it answered `forfeit`");
  return *action;
}

void GuestMind::greet() {
  const auto line = hear(limits_.start, limits_.contest);
  greeted_ = line == guest_greeting;
  if (!line || greeted_) return;
  const char* hint = *line == "mazeWidth" || *line == "mazeHeight" || line->starts_with("wall")
                         ? "; it seems to be written for mms; race it as mms:COMMAND"
                         : "";
  give_up(ForfeitReason::rubbish,
          fmt::format("its first line is {} instead of '{}'{}", quoted_line(*line), guest_greeting, hint));
}

std::optional<std::string_view> GuestMind::hear(std::chrono::milliseconds silence, std::chrono::nanoseconds work) {
  Patience patience(silence, work);
  for (;;) {
    const auto line = process_.lines().next();
    if (patience.is_overworked(process_)) {
      give_up(ForfeitReason::late,
              fmt::format("it worked for {} of processor time{}; the limit is {} ({})", seconds_text(patience.worked()),
                          line ? " for its answer " + quoted_line(*line) : " and had not answered", seconds_text(work),
                          greeted_ ? "--decision-limit" : "--contest-limit"));
      return std::nullopt;
    }
    if (line) return line;
    if (process_.lines().too_long()) {
      give_up(ForfeitReason::flooded, fmt::format("it wrote a line of more than {} bytes: {}", limits_.longest_line,
                                                  quoted_line(process_.lines().rest())));
      return std::nullopt;
    }
    const GuestEvent event = patience.wait(process_, contest_end_);
    if (event == GuestEvent::output || patience.is_overworked(process_)) continue;
    give_up(event, silence);
    return std::nullopt;
  }
}

void GuestMind::give_up(GuestEvent event, std::chrono::milliseconds silence) {
  switch (event) {
    case GuestEvent::ended:
      return give_up(ForfeitReason::died, fmt::format("it ended with {}{}",
                                                      describe(process_.status().value_or(ExitStatus())), too_early()));
    case GuestEvent::left:
      return give_up(ForfeitReason::left, "it ended, but a process that it had started kept its output open");
    case GuestEvent::closed:
      return give_up(ForfeitReason::closed, "it closed its standard output");
    case GuestEvent::exceeded:
      return give_up(reason_of(process_.exceeded()),
                     "it and what it started " + describe(process_.exceeded(), limits_));
    case GuestEvent::interrupted:
      return give_up(ForfeitReason::interrupted, "it was interrupted");
    case GuestEvent::output:
    case GuestEvent::timeout:
      break;
  }
  if (Clock::now() >= contest_end_)
    return give_up(ForfeitReason::out_of_time,
                   fmt::format("its contest took longer than {} (--contest-limit)", seconds_text(limits_.contest)));
  if (process_.deaf()) return give_up(ForfeitReason::closed, "it closed its standard input");
  give_up(ForfeitReason::hung, fmt::format("it was silent for {} ({}){}", seconds_text(silence),
                                           greeted_ ? "--silence-limit" : "--start-limit", behind_silence()));
}

std::string GuestMind::too_early() const {
  if (greeted_) return "";
  return beginning_.empty() ? fmt::format(" before it wrote '{}'", guest_greeting) : " before " + beginning_;
}

std::string GuestMind::behind_silence() {
  const std::string_view begun = process_.lines().rest();
  if (!begun.empty()) return fmt::format("; it wrote {} without ending the line", quoted_line(begun));
  if (greeted_) return "";
  return beginning_.empty() ? "; does it flush after each line?" : " before " + beginning_;
}

void GuestMind::give_up(ForfeitReason reason, std::string sentence) {
  reason_ = reason;
  process_.end(0ms);
  const std::string_view errors = without_end(process_.errors());
  last_words_ = errors.empty() ? std::move(sentence) : fmt::format("{}\n{}", sentence, errors);
}

}  // namespace labmouse
