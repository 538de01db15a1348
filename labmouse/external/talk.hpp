// What is said between us and an external mouse: its greeting, questions and answers, and the end of one that does not
// play by its protocol or its limits.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/external/patience.hpp"
#include "labmouse/external/process.hpp"
#include "labmouse/external/verdict.hpp"

namespace labmouse {

/// A program that was started, and is asked line by line until it is given up.
class ExternalTalk {
 public:
  /// `greeting`: what its first line is to be, for those who read why it was given up.
  ExternalTalk(const Launch& launch, std::string_view greeting);
  ExternalTalk(const ExternalTalk&) = delete;
  ExternalTalk& operator=(const ExternalTalk&) = delete;
  ~ExternalTalk();

  /// Tells it what it is to know, and hears its first line; nothing where it was given up, as in all that follows.
  /// Lines are valid until the next call.
  std::optional<std::string_view> greet(std::string_view briefing);
  /// Its first line was as it should be.
  void accept() { greeted_ = true; }
  /// Its answer, a line.
  std::optional<std::string_view> ask(std::string_view question);
  /// What it wrote behind that line, which should be nothing.
  std::string_view rest() { return process_.lines().rest(); }

  /// Ends the external mouse and keeps why, the first time.
  void give_up(ForfeitReason reason, std::string_view sentence);
  void give_up(const Verdict& verdict) { give_up(verdict.reason, verdict.sentence); }

  bool greeted() const { return greeted_; }
  /// Why it was given up; none while it was not.
  ForfeitReason reason() const { return reason_; }
  /// Why it was given up, and what it wrote to its standard error.
  std::string_view last_words() { return reason_ == ForfeitReason::none ? process_.errors() : last_words_; }

 private:
  using Clock = ExternalProcess::Clock;

  /// Its next line, before which it may take so much of its own time and work for so long.
  std::optional<std::string_view> hear(std::chrono::milliseconds silence, std::chrono::nanoseconds work);
  void give_up(ExternalEvent event, const Patience& patience, std::chrono::milliseconds silence);

  ExternalLimits limits_;
  std::string beginning_;  ///< as of its launch
  std::string greeting_;
  ContestClock contest_;
  ExternalProcess process_;
  bool greeted_ = false;
  ForfeitReason reason_ = ForfeitReason::none;
  std::string last_words_;
};

}  // namespace labmouse
