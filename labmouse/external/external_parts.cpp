#include "labmouse/external/external_parts.hpp"

#include <fmt/format.h>

namespace labmouse {

ExternalParts::ExternalParts(const Launch& launch, std::string_view briefing) : talk_(launch, parts_greeting) {
  const auto line = talk_.greet(briefing);
  if (!line) return;
  const JudgedLine<OfferedParts> greeting = judge_parts_greeting(*line);
  if (greeting.verdict) {
    talk_.give_up(*greeting.verdict);
  } else {
    offered_ = greeting.value;
    talk_.accept();
  }
}

ControllerParts ExternalParts::parts() {
  ControllerParts parts;
  if (offered_.estimator) parts.estimator = this;
  if (offered_.reader) parts.reader = this;
  if (offered_.tracker) parts.tracker = this;
  return parts;
}

void ExternalParts::put(const Position& position, const Direction& ahead) {
  to_say_ += "put";
  add_place(position, ahead, to_say_);
  to_say_ += '\n';
}

PoseEstimate ExternalParts::estimate(const Sense& sense, const Target& target, const Knowledge* /*known*/) {
  to_say_ += "estimate";
  add_sense(sense, to_say_);
  add_target(target, to_say_);
  return ask(judge_estimate);
}

void ExternalParts::begin(const Pose& pose) {
  to_say_ += fmt::format("look {} {} {}\n", pose.cell.x, pose.cell.y, name_of(pose.heading));
  evidence_ = {};
}

void ExternalParts::read(const Sense& sense, const PoseEstimate& estimate) {
  to_say_ += "read";
  add_sense(sense, to_say_);
  add_estimate(estimate, to_say_);
  evidence_ = ask(judge_evidence);
}

void ExternalParts::reset() { to_say_ += "rest\n"; }

Drive ExternalParts::follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) {
  to_say_ += "follow";
  add_sense(sense, to_say_);
  add_target(target, to_say_);
  add_estimate(estimate, to_say_);
  return ask(judge_part_duties);
}

template <class Value>
Value ExternalParts::ask(JudgedLine<Value> (*judge)(std::string_view line, std::string_view more)) {
  to_say_ += '\n';
  const auto line = talk_.ask(to_say_);
  to_say_.clear();
  if (!line) return {};
  JudgedLine<Value> answer = judge(*line, talk_.rest());
  if (answer.verdict) talk_.give_up(*answer.verdict);
  return answer.value;
}

}  // namespace labmouse
