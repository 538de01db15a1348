// Runs a sketch as a controller of labmouse (docs/reference/protocols.md#controllers). The sketch has the thread: each of its
// calls advances the time, and at the end of each millisecond the duties are sent, and the next readings come.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "arduino/Arduino.h"
#include "arduino/EEPROM.h"
#include "board.hpp"

HostSerial Serial;
HostEeprom EEPROM;

namespace {

/// Time that a call takes, in µs.
constexpr double read_us = 4, write_us = 4, clock_us = 3, convert_us = 112, toggle_us = 0.1, loop_us = 1;
constexpr double tick_us = 1000;
constexpr int pins = 22, full_count = 1023, full_duty = 32767, full_pwm = 255;

struct Edge {
  double time;
  int wheel, step;
};

struct Handler {
  void (*function)() = nullptr;
  int mode = CHANGE;
  bool pending = false;
};

struct Chip {
  double now = 0, tick_end = tick_us;  ///< µs
  int mode[pins] = {}, level[pins] = {}, pwm[pins] = {};
  Handler handlers[2];
  bool interrupts_on = true;
  unsigned phase[2] = {};  ///< of the encoders, quarters of a period
  std::vector<Edge> edges;  ///< of this tick, the next one last
  // The last question.
  int infrared_sensors = 0, rangers = 0;
  std::vector<long> infrared;
  long counts[2] = {}, millivolts = 0;
  bool know_counts = false;
};
Chip chip;
std::string program;

[[noreturn]] void end(const char* reason, int code) {
  if (reason != nullptr) std::fprintf(stderr, "firmware-host: %s\n", reason);
  std::exit(code);
}

std::string next_line() {
  std::string line;
  for (int letter = std::getchar(); letter != '\n'; letter = std::getchar()) {
    if (letter == EOF) end(nullptr, 0);
    if (letter != '\r') line += static_cast<char>(letter);
  }
  return line;
}

/// A hand has carried the mouse: the chip is reset, and only its EEPROM stays.
[[noreturn]] void reset(const std::string& question) {
  std::string bytes;
  for (const std::uint8_t byte : EEPROM.bytes) {
    constexpr const char* digits = "0123456789abcdef";
    bytes += digits[byte >> 4];
    bytes += digits[byte & 15];
  }
  const std::string infrared = std::to_string(chip.infrared_sensors), rangers = std::to_string(chip.rangers);
  execl("/proc/self/exe", program.c_str(), infrared.c_str(), rangers.c_str(), question.c_str(), bytes.c_str(), nullptr);
  end("cannot start again after a reset", 1);
}

/// Reads a question. Of several ticks, only the last one can be worked off.
void read_question(const std::string& line) {
  char* rest = const_cast<char*>(line.c_str()) + std::strlen("sense");
  long before[2] = {chip.counts[0], chip.counts[1]};
  while (*rest != '\0') {
    std::strtol(rest, &rest, 10);
    for (long& count : chip.counts) count = std::strtol(rest, &rest, 10);
    for (int i = 0; i < 3; ++i) std::strtol(rest, &rest, 10);  // gyro and accelerometer, which this board lacks
    chip.infrared.clear();
    for (int i = 0; i < chip.infrared_sensors; ++i) chip.infrared.push_back(std::strtol(rest, &rest, 10));
    for (int i = 0; i < 2 * chip.rangers; ++i) std::strtol(rest, &rest, 10);
    char* const last = rest;
    chip.millivolts = std::strtol(rest, &rest, 10);
    if (rest == last) end("a question has too few numbers", 1);
  }
  chip.edges.clear();
  for (int wheel = 0; wheel < 2 && chip.know_counts; ++wheel) {
    const long change = chip.counts[wheel] - before[wheel], size = std::labs(change);
    for (long i = 0; i < size; ++i)
      chip.edges.push_back({chip.tick_end - tick_us * (static_cast<double>(i) + 0.5) / static_cast<double>(size), wheel,
                            change < 0 ? -1 : 1});
  }
  std::stable_sort(chip.edges.begin(), chip.edges.end(), [](const Edge& a, const Edge& b) { return a.time > b.time; });
  chip.know_counts = true;
}

int duty_of(const HostWheel& wheel) {
  const int share = chip.pwm[wheel.pwm] * full_duty / full_pwm;
  return chip.level[wheel.direction] == wheel.level_ahead ? share : -share;
}

void end_tick() {
  std::printf("drive %d %d\n", duty_of(host_wheels[0]), duty_of(host_wheels[1]));
  std::fflush(stdout);
  chip.tick_end += tick_us;
  std::string line = next_line();
  if (line.rfind("carried", 0) == 0) reset(next_line());
  read_question(line);
}

void interrupt(Handler& handler) {
  handler.pending = false;
  chip.interrupts_on = false;
  handler.function();
  chip.interrupts_on = true;
}

void call_pending() {
  for (bool again = true; again && chip.interrupts_on;) {
    again = false;
    for (Handler& handler : chip.handlers)
      if (handler.pending && handler.function != nullptr) {
        interrupt(handler);
        again = true;
      }
  }
}

void set_input(int pin, int level) {
  if (chip.level[pin] == level) return;
  chip.level[pin] = level;
  const std::uint8_t number = digitalPinToInterrupt(static_cast<std::uint8_t>(pin));
  if (number == NOT_AN_INTERRUPT || chip.handlers[number].function == nullptr) return;
  Handler& handler = chip.handlers[number];
  if (handler.mode != CHANGE && handler.mode != (level == HIGH ? RISING : FALLING)) return;
  handler.pending = true;
  call_pending();
}

void turn(const Edge& edge) {
  const HostWheel& wheel = host_wheels[edge.wheel];
  unsigned& phase = chip.phase[edge.wheel];
  phase = (phase + (wheel.a_leads ? 1U : 3U) * static_cast<unsigned>(edge.step)) & 3U;
  const bool a = phase == 1 || phase == 2, b = phase >= 2;
  set_input(wheel.b, b ? HIGH : LOW);
  set_input(wheel.clock, a != b ? HIGH : LOW);
}

/// Lets time pass, with what happens in it.
void advance(double microseconds) {
  const double until = chip.now + microseconds;
  for (;;) {
    const bool has_edge = !chip.edges.empty() && chip.edges.back().time <= until;
    if (!has_edge && chip.tick_end > until) break;
    if (has_edge && chip.edges.back().time <= chip.tick_end) {
      const Edge edge = chip.edges.back();
      chip.edges.pop_back();
      // A handler may have called what takes time.
      chip.now = std::max(chip.now, edge.time);
      turn(edge);
    } else {
      chip.now = std::max(chip.now, chip.tick_end);
      end_tick();
    }
  }
  chip.now = std::max(chip.now, until);
}

bool is_pressed() {
  const double since = chip.now / tick_us;
  return since >= host_press_at && since < host_press_at + host_press_hold;
}

/// mV at a pin of the ADC.
double voltage(int pin) {
  if (pin == host_battery) return static_cast<double>(chip.millivolts) / host_battery_divider;
  if (pin == host_button) return is_pressed() ? host_pressed : host_released;
  for (std::size_t i = 0; i < host_infrared.size() && i < chip.infrared.size(); ++i) {
    const HostInfrared& sensor = host_infrared[i];
    if (sensor.pin != pin) continue;
    const double lit = chip.level[sensor.emitter] == HIGH ? sensor.scale * static_cast<double>(chip.infrared[i]) : 0.0;
    return (std::floor(sensor.ambient + lit) + 0.5) * host_supply / full_count;
  }
  return 0.0;
}

}  // namespace

void pinMode(std::uint8_t pin, std::uint8_t mode) {
  if (pin < pins) chip.mode[pin] = mode;
  advance(write_us);
}

int digitalRead(std::uint8_t pin) {
  advance(read_us);
  return pin < pins ? chip.level[pin] : LOW;
}

void digitalWrite(std::uint8_t pin, std::uint8_t level) {
  if (pin < pins && chip.mode[pin] == OUTPUT) {
    chip.level[pin] = level == LOW ? LOW : HIGH;
    chip.pwm[pin] = level == LOW ? 0 : full_pwm;
  }
  advance(write_us);
}

int analogRead(std::uint8_t pin) {
  if (pin < A0) pin = static_cast<std::uint8_t>(pin + A0);
  advance(convert_us);
  if (pin >= pins) return 0;
  return static_cast<int>(constrain(voltage(pin) / host_supply, 0.0, 1.0) * full_count);
}

void analogWrite(std::uint8_t pin, int duty) {
  pinMode(pin, OUTPUT);
  if (pin < pins) chip.pwm[pin] = constrain(duty, 0, full_pwm);
}

unsigned long micros() {
  advance(clock_us);
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(chip.now)) & ~3UL;  // its timer counts by 4 µs
}

unsigned long millis() {
  advance(clock_us);
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(chip.now / tick_us));
}

void delay(unsigned long milliseconds) { advance(tick_us * static_cast<double>(milliseconds)); }
void delayMicroseconds(unsigned int microseconds) { advance(microseconds); }

void attachInterrupt(std::uint8_t number, void (*handler)(), int mode) {
  if (number < 2) chip.handlers[number] = {handler, mode, false};
}
void detachInterrupt(std::uint8_t number) {
  if (number < 2) chip.handlers[number] = {};
}
void interrupts() {
  chip.interrupts_on = true;
  call_pending();
  advance(toggle_us);
}
void noInterrupts() {
  chip.interrupts_on = false;
  advance(toggle_us);
}

size_t HostSerial::write(std::uint8_t letter) {
  std::fputc(letter, stderr);
  advance(byte_us_);
  return 1;
}
size_t HostSerial::print(const char* text) {
  for (const char* letter = text; *letter != '\0'; ++letter) write(static_cast<std::uint8_t>(*letter));
  return std::strlen(text);
}
size_t HostSerial::print(unsigned long number, int base) {
  std::string digits;
  do {
    digits.insert(digits.begin(), "0123456789ABCDEF"[number % static_cast<unsigned>(base)]);
    number /= static_cast<unsigned>(base);
  } while (number > 0);
  return print(digits.c_str());
}
size_t HostSerial::print(long number, int base) {
  if (number >= 0 || base != DEC) return print(static_cast<unsigned long>(static_cast<std::uint32_t>(number)), base);
  write('-');
  return 1 + print(static_cast<unsigned long>(-number), base);
}
size_t HostSerial::print(double number, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return print(text);
}

int main(int count, char** words) {
  constexpr int words_after_reset = 5;
  program = words[0];
  std::memset(EEPROM.bytes, 0xFF, sizeof EEPROM.bytes);
  if (count == words_after_reset) {
    chip.infrared_sensors = std::atoi(words[1]);
    chip.rangers = std::atoi(words[2]);
    for (int i = 0; i < HostEeprom::size && words[4][2 * i] != '\0'; ++i)
      EEPROM.bytes[i] = static_cast<std::uint8_t>(std::strtol(std::string(words[4] + 2 * i, 2).c_str(), nullptr, 16));
    read_question(words[3]);
  } else {
    for (std::string line = next_line(); line != "begin"; line = next_line()) {
      if (line.rfind("infrared ", 0) == 0) ++chip.infrared_sensors;
      if (line.rfind("ranger ", 0) == 0) ++chip.rangers;
    }
    std::printf("labmouse pilot 1\n");
    std::fflush(stdout);
    read_question(next_line());
  }
  setup();
  for (;;) {
    loop();
    advance(loop_us);
  }
}
