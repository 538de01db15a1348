#include "program_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace labmouse::avr {
namespace {

/// Where avr-gcc has other memories than flash in its one range of addresses.
constexpr std::uint32_t data_begin = 0x800000, eeprom_begin = 0x810000, eeprom_end = 0x820000;

/// The numbers of a file, the lowest byte first. What lies beyond its end reads 0.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t number(std::size_t at, std::size_t size) const {
    constexpr unsigned byte_bits = 8;
    std::uint32_t number = 0;
    for (std::size_t i = size; i-- > 0;)
      number = number << byte_bits | (at + i < bytes_.size() ? static_cast<unsigned char>(bytes_[at + i]) : 0U);
    return number;
  }
  std::uint32_t word(std::size_t at) const { return number(at, 4); }
  std::uint32_t half(std::size_t at) const { return number(at, 2); }

  /// A part of the file; nullopt if it reaches beyond the end.
  std::optional<std::string_view> part(std::size_t begin, std::size_t size) const {
    if (begin > bytes_.size() || size > bytes_.size() - begin) return std::nullopt;
    return bytes_.substr(begin, size);
  }

 private:
  std::string_view bytes_;
};

/// Copies bytes to an address of a memory that grows up to `most`; false if it would be larger.
bool put(std::string_view bytes, std::size_t address, std::size_t most, std::vector<std::uint8_t>& memory) {
  constexpr std::uint8_t erased = 0xFF;
  if (address > most || bytes.size() > most - address) return false;
  memory.resize(std::max(memory.size(), address + bytes.size()), erased);
  std::copy(bytes.begin(), bytes.end(), memory.begin() + static_cast<std::ptrdiff_t>(address));
  return true;
}

void read_segments(const Bytes& file, std::size_t most_flash, std::size_t most_eeprom, ProgramFile& program) {
  const std::size_t table = file.word(28), size = file.half(42), count = file.half(44);
  for (std::size_t i = 0; i < count && program.error.empty(); ++i) {
    const std::size_t header = table + i * size;
    constexpr std::uint32_t loaded = 1;
    if (file.word(header) != loaded || file.word(header + 16) == 0) continue;
    const std::uint32_t address = file.word(header + 12);
    const auto bytes = file.part(file.word(header + 4), file.word(header + 16));
    if (!bytes)
      program.error = "is cut off: a part of its program is missing";
    else if (address < data_begin && !put(*bytes, address, most_flash, program.flash))
      program.error = fmt::format("needs more than the {} bytes of flash memory", most_flash);
    else if (address >= eeprom_begin && address < eeprom_end &&
             !put(*bytes, address - eeprom_begin, most_eeprom, program.eeprom))
      program.error = fmt::format("needs more than the {} bytes of EEPROM", most_eeprom);
  }
}

void read_symbols(const Bytes& file, ProgramFile& program) {
  const std::size_t table = file.word(32), size = file.half(46), count = file.half(48);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t header = table + i * size;
    constexpr std::uint32_t symbol_table = 2;
    constexpr std::size_t symbol_size = 16, function = 2, label = 0;
    if (file.word(header + 4) != symbol_table) continue;
    const auto symbols = file.part(file.word(header + 16), file.word(header + 20));
    const std::size_t names_header = table + file.word(header + 24) * size;
    const auto names = file.part(file.word(names_header + 16), file.word(names_header + 20));
    if (!symbols || !names) return;
    const Bytes entries(*symbols);
    for (std::size_t at = 0; at + symbol_size <= symbols->size(); at += symbol_size) {
      const std::uint32_t name_at = entries.word(at), address = entries.word(at + 4),
                          kind = entries.number(at + 12, 1) & 15U;
      if ((kind != function && kind != label) || address >= program.flash.size() || name_at >= names->size()) continue;
      const std::string_view name = names->substr(name_at, names->substr(name_at).find('\0'));
      // The names with a leading underscore are those of the linker.
      if (!name.empty() && name.front() != '_' && name.front() != '.')
        program.symbols.push_back({address, std::string(name)});
    }
    return;  // a file has one such table
  }
}

}  // namespace

ProgramFile read_program(std::string_view bytes, std::size_t most_flash, std::size_t most_eeprom) {
  constexpr std::size_t header_size = 52, machine_at = 18;
  constexpr std::uint32_t avr_machine = 83;
  constexpr std::string_view magic = "\x7F\x45LF\x01\x01";
  ProgramFile program;
  const Bytes file(bytes);
  if (bytes.size() < header_size || !bytes.starts_with(magic))
    program.error = "is no 32-bit ELF file; give it the file that avr-gcc links, before avr-objcopy";
  else if (file.half(machine_at) != avr_machine)
    program.error = "is an ELF file of another processor; compile it with avr-gcc";
  if (!program.error.empty()) return program;
  read_segments(file, most_flash, most_eeprom, program);
  if (program.error.empty() && program.flash.empty()) program.error = "has no program";
  if (program.error.empty()) read_symbols(file, program);
  return program;
}

}  // namespace labmouse::avr
