// A mouse that is another program: it is asked by lines, and answers by lines.
#pragma once

#include <string>

#include "labmouse/guests/process.hpp"
#include "labmouse/guests/verdict.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Starts the program and greets it, then asks it at each step. A program that does not play by the protocol or its
/// limits is ended, and what it did is a forfeit with that reason.
class GuestMind final : public Strategy {
 public:
  GuestMind(const Launch& launch, const Briefing& briefing);
  ~GuestMind() override;

  Action decide(const Sighting& seen) override;
  /// Nothing: what a guest believes nobody sees.
  const Knowledge& knowledge() const override { return knowledge_; }
  bool started() const override { return greeted_; }
  std::string_view last_words() override { return reason_ == ForfeitReason::none ? process_.errors() : last_words_; }

 private:
  using Clock = GuestProcess::Clock;

  /// Its next line, before which it may be silent for so long and work for so long; nothing where it is to be given up.
  std::optional<std::string_view> hear(std::chrono::milliseconds silence, std::chrono::nanoseconds work);
  void greet();
  /// Ends the guest and keeps why.
  void give_up(ForfeitReason reason, std::string_view sentence);
  void give_up(const Verdict& verdict) { give_up(verdict.reason, verdict.sentence); }
  void give_up(GuestEvent event, std::chrono::milliseconds silence);

  GuestLimits limits_;
  std::string beginning_;  ///< as of its launch
  Knowledge knowledge_;
  Clock::time_point contest_end_;
  GuestProcess process_;
  bool greeted_ = false;
  ForfeitReason reason_ = ForfeitReason::none;
  std::string last_words_;
};

}  // namespace labmouse
