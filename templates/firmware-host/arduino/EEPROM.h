// Stands in for Arduino's EEPROM library: 1024 bytes, which are empty in each contest and outlast resets.
#ifndef LABMOUSE_EEPROM_H
#define LABMOUSE_EEPROM_H

#include <stdint.h>
#include <string.h>

// NOLINTBEGIN: the names are Arduino's.
class HostEeprom {
 public:
  static constexpr int size = 1024;

  uint8_t read(int at) const { return at >= 0 && at < size ? bytes[at] : 0xFF; }
  void write(int at, uint8_t value) {
    if (at >= 0 && at < size) bytes[at] = value;
  }
  void update(int at, uint8_t value) { write(at, value); }
  int length() const { return size; }
  template <class T>
  T& get(int at, T& value) const {
    if (at >= 0 && at + static_cast<int>(sizeof(T)) <= size) memcpy(&value, bytes + at, sizeof(T));
    return value;
  }
  template <class T>
  const T& put(int at, const T& value) {
    if (at >= 0 && at + static_cast<int>(sizeof(T)) <= size) memcpy(bytes + at, &value, sizeof(T));
    return value;
  }

  uint8_t bytes[size];
};
extern HostEeprom EEPROM;
// NOLINTEND

#endif
