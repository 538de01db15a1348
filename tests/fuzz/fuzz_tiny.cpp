// Any bytes as calls of the header for small chips: the mouse stays inside of the maze, and a wrong call changes
// nothing.
#include <cstring>

#include "firmware/labmouse_tiny.h"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {
namespace {

std::uint8_t eeprom[LABMOUSE_TINY_SAVED];

void write_byte(std::uint16_t address, std::uint8_t byte) {
  require(address < sizeof eeprom);
  eeprom[address] = byte;
}
std::uint8_t read_byte(std::uint16_t address) {
  require(address < sizeof eeprom);
  return eeprom[address];
}
int put(int letter) { return letter; }

}  // namespace

LABMOUSE_FUZZER(tiny) {
  std::size_t at = 0;
  const auto next = [&]() -> std::uint8_t { return at < size ? bytes[at++] : 0; };
  labmouse_tiny mouse;
  std::memset(&mouse, next() & 1U ? 0xFF : 0, sizeof mouse);
  std::memset(eeprom, 0, sizeof eeprom);
  while (at < size) {
    const labmouse_tiny before = mouse;
    const std::uint8_t call = next(), a = next();
    labmouse_tiny_move move = LABMOUSE_TINY_END;
    labmouse_tiny* const it = call & 0x80U ? nullptr : &mouse;
    labmouse_tiny_status status = LABMOUSE_TINY_OK;
    switch (call % 16) {
      case 0:
        status = labmouse_tiny_create(it, a);
        break;
      case 1:
        status = labmouse_tiny_start(it, a);
        break;
      case 2: {
        const std::uint8_t goals[2][2] = {{a, next()}, {next(), next()}};
        status = labmouse_tiny_set_goals(it, goals, static_cast<std::uint8_t>(1 + a % 2));
        break;
      }
      case 3:
        status = labmouse_tiny_turned(it, a);
        break;
      case 4:
        status = labmouse_tiny_save(it, a & 1U ? nullptr : write_byte);
        break;
      case 5:
        status = labmouse_tiny_restore(it, a & 1U ? nullptr : read_byte);
        break;
      case 6:
        status = labmouse_tiny_print(it, put);
        break;
      case 7:
        eeprom[a % sizeof eeprom] = next();
        break;
      default:
        if (call & 1U)
          status = labmouse_tiny_observe(it, a & 3U, a >> 2 & 3U, a >> 4 & 3U);
        else
          status = labmouse_tiny_decide(it, a & 1U ? nullptr : &move);
    }
    require(status == LABMOUSE_TINY_OK || std::memcmp(&mouse, &before, sizeof mouse) == 0);
    if (status == LABMOUSE_TINY_OK && call % 16 != 7) require(mouse.x < 16 && mouse.y < 16 && mouse.heading < 4);
  }
  return 0;
}

}  // namespace labmouse::fuzz
