#include "chip.hpp"

#include <fmt/format.h>
#include <simavr/avr_adc.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_extint.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "labmouse/lab/system/files.hpp"
#include "program_file.hpp"

namespace labmouse::avr {
namespace {

constexpr int ticks_in_second = 1000;
constexpr double full_count = 1023.0;
constexpr std::size_t most_bytes = std::size_t{16} << 20U;  // of an ELF file, with all of its debugging information

/// Addresses of registers in data memory.
enum Register : std::size_t {
  tccr0a = 0x44,
  tccr0b = 0x45,
  ocr0a = 0x47,
  ocr0b = 0x48,
  tccr1a = 0x80,
  tccr1b = 0x81,
  icr1 = 0x86,
  ocr1a = 0x88,
  ocr1b = 0x8A,
  tccr2a = 0xB0,
  tccr2b = 0xB1,
  ocr2a = 0xB3,
  ocr2b = 0xB4,
};

/// A pin on which a timer puts out PWM.
struct PwmOutput {
  std::string_view pin;
  Register control_a, control_b, compare, top;
  bool is_b;  ///< the second output of its timer
};
constexpr std::array<PwmOutput, 6> pwm_outputs = {{{"D6", tccr0a, tccr0b, ocr0a, ocr0a, false},
                                                   {"D5", tccr0a, tccr0b, ocr0b, ocr0a, true},
                                                   {"D9", tccr1a, tccr1b, ocr1a, ocr1a, false},
                                                   {"D10", tccr1a, tccr1b, ocr1b, ocr1a, true},
                                                   {"D11", tccr2a, tccr2b, ocr2a, ocr2a, false},
                                                   {"D3", tccr2a, tccr2b, ocr2b, ocr2a, true}}};

/// How a timer counts.
struct Counting {
  int top = 0;  ///< 0: it puts out no PWM
  bool is_fast = false;
};

int word_at(const avr_t& avr, std::size_t address) { return avr.data[address] | avr.data[address + 1] << 8; }

Counting counting_of(const avr_t& avr, const PwmOutput& output) {
  const int a = avr.data[output.control_a], b = avr.data[output.control_b];
  if ((b & 7) == 0) return {};  // it has no clock
  if (output.control_a != tccr1a) {
    const int mode = (a & 3) | ((b >> 1) & 4), compare = avr.data[output.top];
    const bool pwm = (mode & 1) != 0;
    return {pwm ? ((mode & 4) != 0 ? compare : 255) : 0, (mode & 2) != 0};
  }
  const int mode = (a & 3) | ((b >> 1) & 12);
  switch (mode) {
    case 1:
    case 5:
      return {255, mode > 4};
    case 2:
    case 6:
      return {511, mode > 4};
    case 3:
    case 7:
      return {1023, mode > 4};
    case 8:
    case 10:
    case 14:
      return {word_at(avr, icr1), mode == 14};
    case 9:
    case 11:
    case 15:
      return {word_at(avr, ocr1a), mode == 15};
    default:
      return {};
  }
}

/// Why a program cannot go on, and where.
struct Fault {
  std::string reason;
  std::uint32_t place = 0;  ///< the program counter
};

/// That of the chip whose program runs, because simavr's reports have no other parameter.
Fault* fault_of_running = nullptr;

/// Notes errors of the program, and ends it there. simavr itself goes on after an illegal instruction.
void note(avr_t* avr, int level, const char* format, std::va_list /*arguments*/) {
  if (avr == nullptr || level != LOG_ERROR || fault_of_running == nullptr || !fault_of_running->reason.empty()) return;
  const std::string_view text = format;
  const auto says = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  const char* const reason = avr->pc >= avr->flashend ? "jump out of the flash memory"
                             : says("Opcode")         ? "illegal instruction"
                             : says("write address")  ? "write to an address that is no memory"
                             : says("read address")   ? "read from an address that is no memory"
                                                      : nullptr;
  if (reason == nullptr) return;
  *fault_of_running = {reason, avr->pc};
  avr->state = cpu_Crashed;
}

avr_cycle_count_t stop_there(avr_t* /*avr*/, avr_cycle_count_t /*when*/, void* reached) {
  *static_cast<bool*>(reached) = true;
  return 0;
}

void do_not_wait(avr_t* /*avr*/, avr_cycle_count_t /*cycles*/) {}

void print_byte(avr_irq_t* /*irq*/, std::uint32_t byte, void* /*unused*/) {
  std::fputc(static_cast<int>(byte & 0xFFU), stderr);
}

}  // namespace

class Chip::State {
 public:
  State(const std::string& path, const Board& board) : board_(board) {
    const FileContent file = read_found_file(path, most_bytes);
    fault_ = file.error;
    if (!fault_.empty()) return;
    avr_global_logger_set(note);
    avr_ = avr_make_mcu_by_name(board.chip.c_str());
    if (avr_ == nullptr) {
      fault_ = fmt::format("needs a chip that simavr does not have: {}", board.chip);
      return;
    }
    avr_init(avr_);
    program_ = read_program(file.content, std::size_t{avr_->flashend} + 1, std::size_t{avr_->e2end} + 1);
    fault_ = program_.error;
    if (!fault_.empty()) return;
    load();
    avr_->frequency = static_cast<std::uint32_t>(board.frequency);
    avr_->vcc = avr_->avcc = avr_->aref = static_cast<std::uint32_t>(board.supply);
    avr_->gdb_port = 0;
    avr_->run_cycle_limit = 1000;
    avr_->sleep = do_not_wait;
    connect();
    begin();
  }

  ~State() {
    if (avr_ != nullptr) avr_terminate(avr_);
  }

  State(const State&) = delete;
  State& operator=(const State&) = delete;

  Outputs tick(const Readings& readings) {
    Outputs outputs;
    if (!fault_.empty()) return outputs;
    readings_ = readings;
    const avr_cycle_count_t begin = cycle_of(ticks_), end = cycle_of(++ticks_);
    ++since_carried_;
    set_digital_presses();
    set_all_channels();
    for (const Edge& edge : edges_of(readings)) {
      run_to(begin + static_cast<avr_cycle_count_t>(edge.share * static_cast<double>(end - begin)));
      turn(edge.wheel, edge.step);
    }
    run_to(end);
    for (std::size_t wheel = 0; wheel < board_.wheels.size(); ++wheel) outputs.duty[wheel] = duty_of(wheel);
    outputs.goal = has_risen(board_.goal, goal_was_high_);
    outputs.fast = has_risen(board_.fast, fast_was_high_);
    return outputs;
  }

  void carried() {
    if (avr_ == nullptr) return;
    since_carried_ = 0;
    if (!board_.carried_resets) return;
    const auto cycle = avr_->cycle;
    avr_reset(avr_);
    avr_->cycle = cycle;
    begin();
  }

  const std::string& fault() const { return fault_; }

 private:
  struct Edge {
    double share = 0.0;  ///< of the tick
    std::size_t wheel = 0;
    int step = 1;
  };

  void load() {
    avr_loadcode(avr_, program_.flash.data(), static_cast<std::uint32_t>(program_.flash.size()), 0);
    avr_->codeend = static_cast<std::uint32_t>(program_.flash.size());
    // Jumps to where the program has no code are found there: no instruction has this word.
    constexpr std::uint8_t low = 0x01, high = 0x00;
    for (std::size_t at = (program_.flash.size() + 1U) & ~std::size_t{1}; at + 1 <= avr_->flashend; at += 2) {
      avr_->flash[at] = low;
      avr_->flash[at + 1] = high;
    }
    if (program_.eeprom.empty()) return;
    avr_eeprom_desc_t eeprom = {program_.eeprom.data(), 0, static_cast<std::uint32_t>(program_.eeprom.size())};
    avr_ioctl(avr_, AVR_IOCTL_EEPROM_SET, &eeprom);
  }

  void connect() {
    constexpr char port = '0';
    std::uint32_t flags = 0;
    avr_ioctl(avr_, AVR_IOCTL_UART_SET_FLAGS(port), &flags);
    if (avr_irq_t* output = avr_io_getirq(avr_, AVR_IOCTL_UART_GETIRQ(port), UART_IRQ_OUTPUT))
      avr_irq_register_notify(output, print_byte, nullptr);
    if (avr_irq_t* trigger = avr_io_getirq(avr_, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER))
      avr_irq_register_notify(trigger, convert, this);
    // A pin that is low while its interrupt has its mode after a reset, low level, would otherwise interrupt for ever,
    // even in another mode. Encoders interrupt on edges.
    constexpr std::uint8_t external_interrupts = 2;
    for (std::uint8_t i = 0; i < external_interrupts; ++i) avr_extint_set_strict_lvl_trig(avr_, i, 0);
  }

  void begin() {
    since_carried_ = 0;
    for (std::size_t wheel = 0; wheel < board_.wheels.size(); ++wheel) turn(wheel, 0);
  }

  /// A conversion begins: its pin has what the emitters light just now.
  static void convert(avr_irq_t* /*irq*/, std::uint32_t /*multiplexer*/, void* chip) {
    static_cast<State*>(chip)->set_all_channels();
  }

  avr_cycle_count_t cycle_of(std::uint64_t tick) const {
    return tick * static_cast<std::uint64_t>(board_.frequency) / ticks_in_second;
  }

  void run_to(avr_cycle_count_t cycle) {
    if (!fault_.empty() || cycle <= avr_->cycle) return;
    bool reached = false;
    avr_cycle_timer_register(avr_, cycle - avr_->cycle, stop_there, &reached);
    Fault fault;
    fault_of_running = &fault;
    while (!reached && fault.reason.empty()) {
      constexpr std::uint32_t sleep_bytes = 2;
      const int state = avr_run(avr_);
      if (!fault.reason.empty()) break;
      if (state == cpu_Done) fault = {"sleeps for ever, because interrupts are off,", avr_->pc - sleep_bytes};
      if (state == cpu_Crashed || state == cpu_Stopped) fault = {"the chip has stopped", avr_->pc};
    }
    fault_of_running = nullptr;
    if (!reached) avr_cycle_timer_cancel(avr_, stop_there, &reached);
    if (!fault.reason.empty())
      fault_ = fmt::format("{} at 0x{:04x}{}", fault.reason, fault.place, function_at(fault.place));
  }

  /// The function of the program in which that address lies, for people.
  std::string function_at(std::uint32_t address) const {
    if (address >= program_.flash.size()) return ", which has no code";
    const Symbol* found = nullptr;
    for (const Symbol& symbol : program_.symbols)
      if (symbol.address <= address && (found == nullptr || symbol.address > found->address)) found = &symbol;
    return found == nullptr ? "" : fmt::format(" in {}", found->name);
  }

  std::vector<Edge> edges_of(const Readings& readings) const {
    std::vector<Edge> edges;
    for (std::size_t wheel = 0; wheel < readings.edges.size(); ++wheel) {
      const int count = std::abs(readings.edges[wheel]);
      for (int i = 0; i < count; ++i) edges.push_back({(i + 0.5) / count, wheel, readings.edges[wheel] < 0 ? -1 : 1});
    }
    std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.share < b.share; });
    return edges;
  }

  void set_pin(const Pin& pin, bool high) {
    if (pin.port == 0) return;
    avr_raise_irq(avr_io_getirq(avr_, static_cast<std::uint32_t>(AVR_IOCTL_IOPORT_GETIRQ(pin.port)), pin.bit),
                  high ? 1 : 0);
  }

  /// Whether the program drives the pin high.
  bool is_high(const Pin& pin) const {
    constexpr std::size_t ddr_of_b = 0x24, port_of_b = 0x25, next = 3;
    const auto offset = next * static_cast<std::size_t>(pin.port - 'B');
    return pin.port != 0 && ((avr_->data[ddr_of_b + offset] & avr_->data[port_of_b + offset]) >> pin.bit & 1) != 0;
  }

  bool is_output(const Pin& pin) const {
    constexpr std::size_t ddr_of_b = 0x24, next = 3;
    return (avr_->data[ddr_of_b + next * static_cast<std::size_t>(pin.port - 'B')] >> pin.bit & 1) != 0;
  }

  /// Turns a wheel by a count: the pins of its encoder after that.
  void turn(std::size_t wheel, int step) {
    const Wheel& wired = board_.wheels[wheel];
    unsigned& phase = phases_[wheel];
    phase = (phase + (wired.a_leads ? 1U : 3U) * static_cast<unsigned>(step)) & 3U;
    const bool a = phase == 1 || phase == 2, b = phase >= 2;
    // The interrupt of a clock finds B as it is after the edge.
    set_pin(wired.b, b);
    set_pin(wired.a, wired.is_clock ? a != b : a);
  }

  const Press* pressed(const Pin& pin) const {
    for (const Press& press : board_.presses)
      if (press.pin == pin && since_carried_ > press.at && since_carried_ <= press.at + press.hold) return &press;
    return nullptr;
  }

  void set_digital_presses() {
    for (const Press& press : board_.presses)
      set_pin(press.pin, 2 * (pressed(press.pin) != nullptr ? press.pressed : press.released) > board_.supply);
  }

  void set_channel(const Pin& pin, double millivolts) {
    const double most = board_.supply;
    avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0 + pin.channel),
                  static_cast<std::uint32_t>(std::lround(std::clamp(millivolts, 0.0, most))));
  }

  void set_all_channels() {
    for (const Press& press : board_.presses)
      if (press.pin.channel >= 0)
        set_channel(press.pin, pressed(press.pin) != nullptr ? press.pressed : press.released);
    if (board_.battery) set_channel(*board_.battery, readings_.millivolts / board_.divider);
    for (std::size_t i = 0; i < board_.receivers.size(); ++i) {
      const Receiver& receiver = board_.receivers[i];
      const bool lit = (!receiver.emitter || is_high(*receiver.emitter)) && i < readings_.infrared.size();
      const double counts = receiver.ambient + (lit ? receiver.scale * readings_.infrared[i] : 0.0);
      const Press* const hand = lit ? pressed(receiver.pin) : nullptr;
      // The ADC rounds down: half a count more, so that it reads this one.
      set_channel(receiver.pin,
                  hand != nullptr ? hand->pressed : (std::floor(counts) + 0.5) * board_.supply / full_count);
    }
  }

  /// The share of time in which a pin is high.
  double share_of(const Pin& pin) const {
    if (!is_output(pin)) return 0.0;
    for (const PwmOutput& output : pwm_outputs) {
      if (find_pin(output.pin) != pin) continue;
      const int connected = avr_->data[output.control_a] >> (output.is_b ? 4 : 6) & 3;
      if (connected < 2) break;
      const Counting counting = counting_of(*avr_, output);
      if (counting.top == 0) return 0.0;
      const int compare = output.control_a == tccr1a ? word_at(*avr_, output.compare) : avr_->data[output.compare];
      const double share =
          counting.is_fast ? (compare + 1.0) / (counting.top + 1.0) : static_cast<double>(compare) / counting.top;
      return connected == 2 ? std::min(share, 1.0) : std::max(1.0 - share, 0.0);
    }
    return is_high(pin) ? 1.0 : 0.0;
  }

  double duty_of(std::size_t wheel) const {
    const Wheel& wired = board_.wheels[wheel];
    const double share = share_of(wired.pwm);
    if (wired.back_pwm) return share - share_of(*wired.back_pwm);
    return is_high(*wired.direction) == wired.ahead_is_high ? share : -share;
  }

  bool has_risen(const std::optional<Pin>& pin, bool& was_high) {
    const bool high = pin && is_high(*pin), risen = high && !was_high;
    was_high = high;
    return risen;
  }

  const Board board_;
  ProgramFile program_;
  avr_t* avr_ = nullptr;
  Readings readings_;
  std::string fault_;
  std::uint64_t ticks_ = 0;
  std::int64_t since_carried_ = 0;    ///< ms
  std::array<unsigned, 2> phases_{};  ///< of the encoders, quarters of a period
  bool goal_was_high_ = false, fast_was_high_ = false;
};

Chip::Chip(const std::string& path, const Board& board) : state_(std::make_unique<State>(path, board)) {}
Chip::~Chip() = default;
Outputs Chip::tick(const Readings& readings) { return state_->tick(readings); }
void Chip::carried() { state_->carried(); }
const std::string& Chip::fault() const { return state_->fault(); }

}  // namespace labmouse::avr
