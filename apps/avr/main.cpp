// labmouse-avr: a controller that runs the firmware of a real robot. It is a program of its own, because it links
// simavr, whose licence is the GPL, version 3; labmouse starts it for mice `firmware:ROBOT.elf`.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "board.hpp"
#include "chip.hpp"
#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/robots/builtin_boards.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace {

using labmouse::avr::Board;
using labmouse::avr::Chip;
using labmouse::avr::Outputs;
using labmouse::avr::Readings;

/// Where answers go. What simavr prints goes to standard error.
std::FILE* answers = nullptr;

void tell(std::string_view text) { fmt::print(stderr, "labmouse-avr: {}\n", labmouse::shown(text)); }

void answer(const std::string& line) {
  fmt::print(answers, "{}\n", line);
  std::fflush(answers);
}

std::optional<std::string> next_line() {
  std::string line;
  for (int letter = std::fgetc(stdin); letter != EOF; letter = std::fgetc(stdin)) {
    if (letter == '\n') return line;
    if (letter != '\r') line += static_cast<char>(letter);
  }
  return std::nullopt;
}

/// The board in a file or of a name; says what is wrong with it.
std::optional<Board> board_of(const std::string& name) {
  std::string text;
  for (const labmouse::BuiltinBoard& board : labmouse::builtin_boards())
    if (board.name == name) text = board.text;
  if (text.empty()) {
    const labmouse::FileContent file = labmouse::read_found_file(name);
    if (!file.error.empty()) {
      tell(fmt::format("error: board '{}': {}", name, file.error));
      return std::nullopt;
    }
    text = file.content;
  }
  const labmouse::avr::BoardResult read = labmouse::avr::read_board(text);
  for (const labmouse::Problem& problem : read.problems)
    tell(fmt::format("{}:{}:{}: {}", name, problem.line, problem.column, problem.reason));
  return read.problems.empty() ? std::optional(read.board) : std::nullopt;
}

/// The numbers of a question, in order.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : text_(text) {}

  std::optional<std::int64_t> next() {
    if (text_.starts_with(' ')) text_.remove_prefix(1);
    return labmouse::take_whole<std::int64_t>(text_);
  }
  bool skip(int count) {
    bool good = true;
    for (int i = 0; i < count; ++i) good = next().has_value() && good;
    return good;
  }
  bool is_over() const { return text_.empty(); }

 private:
  std::string_view text_;
};

/// Reads questions about a robot with that many sensors.
class Questions {
 public:
  /// Counts the sensors in a line of the briefing.
  void learn(std::string_view line) {
    if (line.starts_with("infrared ")) ++infrared_;
    if (line.starts_with("ranger ")) ++rangers_;
  }
  int infrared() const { return infrared_; }

  /// The readings of the last tick of a question; nullopt if it has other numbers than the briefing promised.
  std::optional<Readings> read(std::string_view line) {
    Numbers numbers(line);
    Readings readings;
    while (!numbers.is_over()) {
      numbers.next();  // the time
      for (std::size_t wheel = 0; wheel < counts_.size(); ++wheel) {
        const auto count = numbers.next();
        if (!count) return std::nullopt;
        // The counters wrap at a power of two that is at least 2^8.
        if (know_counts_) readings.edges[wheel] += difference(*count, counts_[wheel]);
        counts_[wheel] = *count;
      }
      know_counts_ = true;
      constexpr int gyro_and_accelerometer = 3;
      if (!numbers.skip(gyro_and_accelerometer)) return std::nullopt;
      readings.infrared.clear();
      for (int i = 0; i < infrared_; ++i) readings.infrared.push_back(static_cast<int>(numbers.next().value_or(0)));
      const auto millivolts = numbers.skip(2 * rangers_) ? numbers.next() : std::nullopt;
      if (!millivolts) return std::nullopt;
      readings.millivolts = static_cast<int>(*millivolts);
    }
    return readings;
  }
  /// A hand has carried the mouse: the wheels have turned unseen.
  void carried() { know_counts_ = false; }

  void set_bits(int bits) { bits_ = bits; }

 private:
  int difference(std::int64_t now, std::int64_t before) const {
    const std::int64_t range = std::int64_t{1} << bits_;
    std::int64_t step = (now - before) % range;
    if (step >= range / 2) step -= range;
    if (step < -range / 2) step += range;
    return static_cast<int>(step);
  }

  int infrared_ = 0, rangers_ = 0, bits_ = 32;
  bool know_counts_ = false;
  std::array<std::int64_t, 2> counts_{};
};

std::string answer_of(const Outputs& outputs) {
  constexpr double full = 32767.0;
  const char* word = outputs.goal ? "goal" : outputs.fast ? "fast" : "drive";
  return fmt::format("{} {} {}", word, std::lround(full * outputs.duty[0]), std::lround(full * outputs.duty[1]));
}

int drive(const std::string& path, const Board& board) {
  Questions questions;
  for (auto line = next_line(); line && *line != "begin"; line = next_line()) {
    questions.learn(*line);
    constexpr std::string_view bits = "sensors.count_bits ";
    if (line->starts_with(bits))
      questions.set_bits(labmouse::parse_whole<int>(std::string_view(*line).substr(bits.size())).value_or(32));
  }
  if (questions.infrared() < static_cast<int>(board.receivers.size())) {
    tell(
        fmt::format("error: the board has {} infrared sensors, and the robot {}; race with another --robot, or leave "
                    "out the tables [[infrared]] that are too many",
                    board.receivers.size(), questions.infrared()));
    return 1;
  }
  Chip chip(path, board);
  if (!chip.fault().empty()) {
    tell(fmt::format("error: '{}' {}", path, chip.fault()));
    return 1;
  }
  answer("labmouse pilot 1");
  for (auto line = next_line(); line; line = next_line()) {
    constexpr std::string_view sense = "sense";
    if (line->starts_with("carried")) {
      chip.carried();
      questions.carried();
      continue;
    }
    if (!line->starts_with(sense)) continue;
    const auto readings = questions.read(std::string_view(*line).substr(sense.size()));
    if (!readings) {
      tell("error: a question has too few numbers");
      return 1;
    }
    const Outputs outputs = chip.tick(*readings);
    if (!chip.fault().empty()) {
      tell(chip.fault());
      answer("forfeit");
      return 0;
    }
    answer(answer_of(outputs));
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  answers = stdout;
  stdout = stderr;
  constexpr const char* usual_board = "ukmarsbot";
  if (count < 2 || count > 3) {
    tell("usage: labmouse-avr ROBOT.elf [BOARD.toml]; labmouse starts it for mice firmware:ROBOT.elf");
    return 2;
  }
  const auto board = board_of(count == 3 ? words[2] : usual_board);
  return board ? drive(words[1], *board) : 1;
}
