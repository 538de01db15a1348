// Any bytes as what an external mouse says: lines come out whole and within their limit, whatever portions they came
// in, and an answer is one that the world can perform and a record can hold.
#include <fmt/format.h>

#include "labmouse/external/controller_protocol.hpp"
#include "labmouse/external/line_buffer.hpp"
#include "labmouse/external/protocol.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

constexpr std::size_t longest = 40;

/// All lines that the text gives in portions of that size, and whether it ended with one that is too long.
std::pair<std::vector<std::string>, bool> lines_of(std::string_view text, std::size_t portion) {
  LineBuffer buffer(longest);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < text.size() && !buffer.too_long(); i += portion) {
    buffer.append(text.substr(i, portion));
    while (const auto line = buffer.next()) lines.emplace_back(*line);
  }
  return {lines, buffer.too_long()};
}

void check_answer(std::string_view line) {
  const auto action = read_answer(line);
  if (!action || action->kind != Action::Kind::step) return;
  require(action->rotation >= -1'000'000 && action->rotation <= 1'000'000);
  require(action->movement >= -1'000'000 && action->movement <= 1'000'000);
  require(read_answer(fmt::format("move {} {}", action->rotation, action->movement)) == action);
}

/// The answer of one that drives itself, of any length.
void check_duties(std::string_view line) {
  const auto ticks = read_duties(line);
  if (!ticks) return;
  require(!ticks->empty() && ticks->size() <= longest_batch);
  for (const ControllerTick& tick : *ticks) {
    require(tick.left >= -ControllerTick::full && tick.right >= -ControllerTick::full);
    require(&tick == &ticks->front() || tick.word == ControllerWord::drive);
  }
  if (ticks->front().word != ControllerWord::drive) return;
  std::string again = "drive";
  for (const ControllerTick& tick : *ticks) again += fmt::format(" {} {}", tick.left, tick.right);
  require(read_duties(again) == ticks);
}

/// The answers of parts of the controller.
void check_parts(std::string_view line) {
  if (const auto estimate = read_estimate(line)) {
    require(estimate->is_valid());
    std::string again = "estimate";
    add_estimate(*estimate, again);
    require(read_estimate(again).has_value());
  }
  if (const auto duties = read_part_duties(line)) require(duties->left >= -1.0F && duties->right <= 1.0F);
  if (const auto evidence = read_evidence(line))
    require(read_evidence(fmt::format("evidence {} {} {}", evidence->left, evidence->ahead, evidence->right)) ==
            evidence);
  if (const auto offered = read_parts_greeting(line)) require(offered != OfferedParts());
}

}  // namespace

LABMOUSE_FUZZER(program) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const auto [lines, too_long] = lines_of(text, size + 1);
  require(lines_of(text, 1) == std::pair(lines, too_long) && lines_of(text, 7) == std::pair(lines, too_long));
  for (const std::string& line : lines) {
    require(line.size() <= longest && line.find_first_of("\r\n") == std::string::npos);
    check_answer(line);
    check_duties(line);
    check_parts(line);
  }
  check_duties(text);
  check_parts(text);
  check_duties(text.substr(0, text.find('\n')));
  return 0;
}

}  // namespace labmouse::fuzz
