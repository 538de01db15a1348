// The dialogue with an external mouse: greeting, questions and answers, and the end of a mouse that violates the
// protocol or a limit.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/external/patience.hpp"
#include "labmouse/external/process.hpp"
#include "labmouse/external/verdict.hpp"

namespace labmouse {

/// A running program that is asked line by line until it is given up.
class ExternalTalk {
 public:
  /// `greeting`: its expected first line, for messages.
  ExternalTalk(const Launch& launch, std::string_view greeting);
  ExternalTalk(const ExternalTalk&) = delete;
  ExternalTalk& operator=(const ExternalTalk&) = delete;
  ~ExternalTalk();

  /// Sends the briefing, and returns its first line; nullopt if it was given up, here and below. Lines are valid until
  /// the next call.
  std::optional<std::string_view> greet(std::string_view briefing);
  /// Marks its first line as correct.
  void accept() { greeted_ = true; }
  /// Sends a question, and returns its answer, one line.
  std::optional<std::string_view> ask(std::string_view question);
  /// What it wrote after that line, which should be empty.
  std::string_view rest() { return process_.lines().rest(); }

  /// Ends the external mouse; the first reason is kept.
  void give_up(ForfeitReason reason, std::string_view sentence);
  void give_up(const Verdict& verdict) { give_up(verdict.reason, verdict.sentence); }

  bool greeted() const { return greeted_; }
  /// Why it was given up; `none` if it was not.
  ForfeitReason reason() const { return reason_; }
  /// What it wrote to its standard error.
  std::string_view errors() { return process_.errors(); }
  /// Why it was given up, and what it wrote to its standard error.
  std::string_view last_words() { return reason_ == ForfeitReason::none ? process_.errors() : last_words_; }

 private:
  using Clock = ExternalProcess::Clock;

  /// Its next line, with limits of own time and processor time.
  std::optional<std::string_view> hear(std::chrono::milliseconds silence, std::chrono::nanoseconds work);
  void give_up(ExternalEvent event, const Patience& patience, std::chrono::milliseconds silence);

  ExternalLimits limits_;
  std::string beginning_;  ///< from its Launch
  std::string greeting_;
  ContestClock contest_;
  ExternalProcess process_;
  bool greeted_ = false;
  ForfeitReason reason_ = ForfeitReason::none;
  std::string last_words_;
};

}  // namespace labmouse
