// Stands in for the Arduino core, so that a sketch runs as a controller of labmouse. host.cpp has what it declares. Time is
// simulated: each call takes about as long as on an ATmega328P at 16 MHz, and interrupts come during calls.
#ifndef LABMOUSE_ARDUINO_H
#define LABMOUSE_ARDUINO_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <algorithm>

typedef uint8_t byte;
typedef bool boolean;
typedef uint16_t word;

enum : uint8_t { LOW = 0, HIGH = 1 };
enum : uint8_t { INPUT = 0, OUTPUT = 1, INPUT_PULLUP = 2 };
enum : uint8_t { CHANGE = 1, FALLING = 2, RISING = 3 };
enum : uint8_t { A0 = 14, A1, A2, A3, A4, A5, A6, A7, LED_BUILTIN = 13, NOT_AN_INTERRUPT = 255 };
enum { DEC = 10, HEX = 16, OCT = 8, BIN = 2 };

using std::max;
using std::min;
template <class T>
T constrain(T x, T low, T high) {
  return x < low ? low : x > high ? high : x;
}
inline long map(long x, long in_low, long in_high, long low, long high) {
  return (x - in_low) * (high - low) / (in_high - in_low) + low;
}
#define bitRead(value, bit) (((value) >> (bit)) & 1)
#define bitSet(value, bit) ((value) |= (1UL << (bit)))
#define bitClear(value, bit) ((value) &= ~(1UL << (bit)))
#define F(text) (text)
#define PROGMEM
#define pgm_read_byte(address) (*(const uint8_t*)(address))
#define pgm_read_word(address) (*(const uint16_t*)(address))

// NOLINTBEGIN: the names are Arduino's.
void pinMode(uint8_t pin, uint8_t mode);
int digitalRead(uint8_t pin);
void digitalWrite(uint8_t pin, uint8_t level);
int analogRead(uint8_t pin);
void analogWrite(uint8_t pin, int duty);

unsigned long micros();
unsigned long millis();
void delay(unsigned long milliseconds);
void delayMicroseconds(unsigned int microseconds);

inline uint8_t digitalPinToInterrupt(uint8_t pin) {
  if (pin == 2) return 0;
  return pin == 3 ? 1 : NOT_AN_INTERRUPT;
}
void attachInterrupt(uint8_t number, void (*handler)(), int mode);
void detachInterrupt(uint8_t number);
void interrupts();
void noInterrupts();
#define cli() noInterrupts()
#define sei() interrupts()

/// Writes to standard error, which labmouse keeps. Nothing is ever received.
class HostSerial {
 public:
  void begin(unsigned long baud) { byte_us_ = baud > 0 ? 10e6 / static_cast<double>(baud) : 0; }
  size_t write(uint8_t letter);
  size_t print(const char* text);
  size_t print(char letter) { return write(static_cast<uint8_t>(letter)); }
  size_t print(long number, int base = DEC);
  size_t print(unsigned long number, int base = DEC);
  size_t print(int number, int base = DEC) { return print(static_cast<long>(number), base); }
  size_t print(unsigned number, int base = DEC) { return print(static_cast<unsigned long>(number), base); }
  size_t print(double number, int digits = 2);
  size_t println() { return print("\r\n"); }
  template <class T>
  size_t println(T value) {
    const size_t size = print(value);
    return size + println();
  }
  template <class T>
  size_t println(T value, int format) {
    const size_t size = print(value, format);
    return size + println();
  }
  int available() const { return 0; }
  int read() const { return -1; }
  void flush() {}
  explicit operator bool() const { return true; }

 private:
  double byte_us_ = 0;
};
extern HostSerial Serial;

void setup();
void loop();
// NOLINTEND

#endif
