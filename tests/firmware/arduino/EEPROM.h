/* A small stand-in for Arduino's own header. */
#ifndef EEPROM_H
#define EEPROM_H
#include <stdint.h>

struct EEPROMClass {
  uint8_t read(int address);
  void update(int address, uint8_t byte);
};
extern EEPROMClass EEPROM;
#endif
