// Reads the ELF file of a program for AVR. simavr's own reader trusts its files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace labmouse::avr {

/// A function or a label of a program.
struct Symbol {
  std::uint32_t address = 0;  ///< in flash memory, bytes
  std::string name;
};

/// What is written to the memories of a chip.
struct ProgramFile {
  std::vector<std::uint8_t> flash;   ///< from address 0
  std::vector<std::uint8_t> eeprom;  ///< from address 0; empty if the file has none
  std::vector<Symbol> symbols;       ///< of the flash memory, in the order of the file
  std::string error;                 ///< why it is no such program; empty on success
};

/// Parses an ELF file.
/// @param bytes the whole file.
/// @param most_flash bytes of flash memory of the chip.
/// @param most_eeprom bytes of its EEPROM.
ProgramFile read_program(std::string_view bytes, std::size_t most_flash, std::size_t most_eeprom);

}  // namespace labmouse::avr
