// Parts of the built-in controller that run as another program.
#pragma once

#include <string>

#include "labmouse/controller/parts.hpp"
#include "labmouse/external/controller_protocol.hpp"
#include "labmouse/external/talk.hpp"

namespace labmouse {

/// Starts the program, exchanges greetings, then asks each part that the program offers once a tick. A program that
/// violates the protocol or a limit is ended, and its parts give up with that reason.
class ExternalParts final : public PartsOwner, EstimatorPart, ReaderPart, TrackerPart {
 public:
  /// `briefing`: the lines from the greeting to `begin`.
  ExternalParts(const Launch& launch, std::string_view briefing);

  /// Those that the program offers; all if it offered none, so that the contest ends with its reason.
  ControllerParts parts() override;
  bool started() const override { return talk_.greeted(); }
  std::string_view last_words() override { return talk_.last_words(); }

 private:
  ForfeitReason reason() const override { return talk_.reason(); }
  void put(const Position& position, const Direction& ahead) override;
  PoseEstimate estimate(const Sense& sense, const Target& target, const Knowledge* known) override;
  void begin(const Pose& pose) override;
  void read(const Sense& sense, const PoseEstimate& estimate) override;
  WallEvidence evidence(const PoseEstimate& /*estimate*/) const override { return evidence_; }
  void reset() override;
  Drive follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) override;

  /// Sends what is to say, and returns the value of the answer; a default one if the program was given up.
  template <class Value>
  Value ask(JudgedLine<Value> (*judge)(std::string_view line, std::string_view more));

  ExternalTalk talk_;
  OfferedParts offered_{true, true, true};
  std::string to_say_;     ///< events that were not yet sent, and the question
  WallEvidence evidence_;  ///< of its last answer
};

}  // namespace labmouse
