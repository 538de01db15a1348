#include "labmouse/external/controller_protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <limits>

#include "labmouse/external/quoted_line.hpp"
#include "labmouse/functions/parse_number.hpp"

namespace labmouse {
namespace {

/// First words of answers; the first three are followed by duties.
constexpr std::array<std::pair<std::string_view, ControllerWord>, 5> words = {{{"drive", ControllerWord::drive},
                                                                               {"fast", ControllerWord::fast},
                                                                               {"goal", ControllerWord::goal},
                                                                               {"carry", ControllerWord::carry},
                                                                               {"forfeit", ControllerWord::give_up}}};

/// Removes one blank and the word after it from the front of the text; returns an empty word if there is none.
std::string_view take_word(std::string_view& text) {
  if (!text.starts_with(' ')) return {};
  text.remove_prefix(1);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

/// Removes one blank and a number from the front of the text; false if there is none.
bool take_real(std::string_view& text, double& number) {
  number = 0.0;
  const NumberProblem problem = parse_number(take_word(text), number);
  return problem == NumberProblem::none || problem == NumberProblem::too_small;
}

void add_reals(std::initializer_list<double> numbers, std::string& text) {
  for (const double number : numbers) fmt::format_to(std::back_inserter(text), " {}", number);
}

/// The answer of a part as it was read, or a verdict. `usual`: what it should have answered.
template <class Value>
JudgedLine<Value> judged(const std::optional<Value>& read, std::string_view line, std::string_view more,
                         std::string_view usual) {
  if (!read && line == "forfeit") return {{}, Verdict{ForfeitReason::gave_up, "it answered `forfeit`"}};
  if (!read)
    return {{},
            Verdict{ForfeitReason::invalid_answer,
                    fmt::format("it answered {} instead of {} or `forfeit`", quoted_line(line), usual)}};
  if (!more.empty()) return {{}, wrote_more(line, more)};
  return {*read, std::nullopt};
}

/// Removes one blank and a duty from the front of the text; false if there is none.
bool take_duty(std::string_view& text, std::int16_t& duty) {
  if (!text.starts_with(' ')) return false;
  text.remove_prefix(1);
  const auto number = take_whole<int>(text);
  if (!number || *number < -ControllerTick::full || *number > ControllerTick::full) return false;
  duty = static_cast<std::int16_t>(*number);
  return true;
}

}  // namespace

void add_sense(const Sense& sense, std::string& text) {
  const auto add = [&](auto number) {
    const fmt::format_int digits(number);
    text += ' ';
    text.append(digits.data(), digits.size());
  };
  add(sense.tick);
  for (const std::int32_t count : sense.counts) add(count);
  add(int{sense.gyro});
  for (const std::int16_t acceleration : sense.acceleration) add(int{acceleration});
  for (const std::int16_t level : sense.all_infrared()) add(int{level});
  for (const RangeSense& range : sense.all_ranges()) {
    add(unsigned{range.distance});
    add(range.is_new ? 1 : 0);
  }
  add(unsigned{sense.millivolts});
}

std::optional<std::vector<ControllerTick>> read_duties(std::string_view line) {
  const std::string_view name = line.substr(0, line.find(' '));
  const auto* const word =
      std::find_if(words.begin(), words.end(), [&](const auto& each) { return each.first == name; });
  if (word == words.end()) return std::nullopt;
  line.remove_prefix(name.size());
  std::vector<ControllerTick> ticks;
  const bool drives = word->second != ControllerWord::carry && word->second != ControllerWord::give_up;
  if (!drives) ticks.emplace_back();
  for (; drives && !line.empty() && ticks.size() < longest_batch;) {
    ControllerTick& tick = ticks.emplace_back();
    if (!take_duty(line, tick.left) || !take_duty(line, tick.right)) return std::nullopt;
  }
  if (ticks.empty() || !line.empty()) return std::nullopt;
  ticks.front().word = word->second;
  return ticks;
}

JudgedLine<AnswerUnits> judge_controller_greeting(std::string_view line) {
  if (line == controller_greeting) return {AnswerUnits::duties, std::nullopt};
  if (line == speeds_greeting) return {AnswerUnits::speeds, std::nullopt};
  const char* hint = line == program_greeting    ? "; it decides step by step; race it as program:COMMAND"
                     : read_parts_greeting(line) ? "; it has parts of a controller; race it as MOUSE:parts=COMMAND"
                                                 : "";
  return {{},
          Verdict{ForfeitReason::invalid_answer,
                  fmt::format("its first line is {} instead of '{}' or '{}'{}", quoted_line(line), controller_greeting,
                              speeds_greeting, hint)}};
}

DutiesAnswer judge_duties(std::string_view line, std::string_view more) {
  auto ticks = read_duties(line);
  if (!ticks)
    return {{},
            Verdict{ForfeitReason::invalid_answer,
                    fmt::format("it answered {} instead of `drive`, `fast` or `goal` with 1 to {} pairs of duties from "
                                "-{} to {}, `carry` or `forfeit`",
                                quoted_line(line), longest_batch, ControllerTick::full, ControllerTick::full)}};
  if (!more.empty()) return {{}, wrote_more(line, more)};
  if (ticks->front().word == ControllerWord::give_up)
    return {{}, Verdict{ForfeitReason::gave_up, "it answered `forfeit`"}};
  return {std::move(*ticks), std::nullopt};
}

void add_place(const Position& position, const Direction& ahead, std::string& text) {
  add_reals({position.x, position.y, ahead.cosine, ahead.sine}, text);
}

void add_target(const Target& target, std::string& text) {
  add_place(target.position, target.ahead, text);
  add_reals({target.speed, target.speeding, target.turning, target.twisting}, text);
}

void add_estimate(const PoseEstimate& estimate, std::string& text) {
  add_place(estimate.position, estimate.ahead, text);
  const auto& p = estimate.covariance;
  add_reals({estimate.slip, estimate.speed, estimate.turning, p[0][0], p[0][1], p[0][2], p[1][1], p[1][2], p[2][2]},
            text);
}

std::optional<OfferedParts> read_parts_greeting(std::string_view line) {
  if (!line.starts_with(controller_greeting)) return std::nullopt;
  line.remove_prefix(controller_greeting.size());
  OfferedParts offered;
  const std::array<std::pair<std::string_view, bool*>, 3> parts = {
      {{"estimator", &offered.estimator}, {"reader", &offered.reader}, {"tracker", &offered.tracker}}};
  do {
    const std::string_view name = take_word(line);
    const auto* const part =
        std::find_if(parts.begin(), parts.end(), [&](const auto& each) { return each.first == name; });
    if (part == parts.end() || *part->second) return std::nullopt;
    *part->second = true;
  } while (!line.empty());
  return offered;
}

std::optional<PoseEstimate> read_estimate(std::string_view line) {
  constexpr std::string_view word = "estimate";
  if (!line.starts_with(word)) return std::nullopt;
  line.remove_prefix(word.size());
  PoseEstimate said;
  auto& p = said.covariance;
  for (double* number : {&said.position.x, &said.position.y, &said.ahead.cosine, &said.ahead.sine, &said.slip,
                         &said.speed, &said.turning, &p[0][0], &p[0][1], &p[0][2], &p[1][1], &p[1][2], &p[2][2]})
    if (!take_real(line, *number)) return std::nullopt;
  return line.empty() && said.is_valid() ? std::optional(said) : std::nullopt;
}

std::optional<WallEvidence> read_evidence(std::string_view line) {
  constexpr std::string_view word = "evidence";
  constexpr int most = std::numeric_limits<Evidence>::max();
  if (!line.starts_with(word)) return std::nullopt;
  line.remove_prefix(word.size());
  WallEvidence said;
  for (Evidence* evidence : {&said.left, &said.ahead, &said.right}) {
    const auto number = parse_whole<int>(take_word(line));
    if (!number || *number < -most || *number > most) return std::nullopt;
    *evidence = static_cast<Evidence>(*number);
  }
  return line.empty() ? std::optional(said) : std::nullopt;
}

std::optional<Drive> read_part_duties(std::string_view line) {
  const auto ticks = read_duties(line);
  if (!ticks || ticks->size() != 1 || ticks->front().word != ControllerWord::drive) return std::nullopt;
  return ticks->front().drive();
}

JudgedLine<OfferedParts> judge_parts_greeting(std::string_view line) {
  if (const auto offered = read_parts_greeting(line)) return {*offered, std::nullopt};
  const char* hint = line == controller_greeting ? "; it is a whole controller; race it as controller:COMMAND" : "";
  return {
      {},
      Verdict{ForfeitReason::invalid_answer,
              fmt::format("its first line is {} instead of '{}' with one or more of estimator, reader and tracker{}",
                          quoted_line(line), parts_greeting, hint)}};
}

JudgedLine<PoseEstimate> judge_estimate(std::string_view line, std::string_view more) {
  return judged(read_estimate(line), line, more,
                "`estimate` with 13 numbers, of which none is beyond a million, the slip angle at most 1 rad and the "
                "direction of length 1,");
}

JudgedLine<WallEvidence> judge_evidence(std::string_view line, std::string_view more) {
  return judged(read_evidence(line), line, more, "`evidence` with 3 whole numbers from -127 to 127");
}

JudgedLine<Drive> judge_part_duties(std::string_view line, std::string_view more) {
  return judged(read_part_duties(line), line, more,
                fmt::format("`drive` with 2 duties from -{0} to {0}", ControllerTick::full));
}

}  // namespace labmouse
