#include "labmouse/external/controller_protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

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
  for (const std::int16_t level : sense.infrared) add(int{level});
  add(unsigned{sense.range});
  add(sense.range_new ? 1 : 0);
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

std::optional<Verdict> judge_controller_greeting(std::string_view line) {
  if (line == controller_greeting) return std::nullopt;
  const char* hint = line == program_greeting ? "; it decides step by step; race it as program:COMMAND" : "";
  return Verdict{ForfeitReason::invalid_answer,
                 fmt::format("its first line is {} instead of '{}'{}", quoted_line(line), controller_greeting, hint)};
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

}  // namespace labmouse
