/* A small stand-in for Arduino's own header: enough to compile the examples of firmware/, not to run them. */
#ifndef ARDUINO_H
#define ARDUINO_H
#include <stddef.h>
#include <stdint.h>

enum { LOW, HIGH };
enum { INPUT, OUTPUT, INPUT_PULLUP };
enum { A0 = 14, A1, A2, A3, A4, A5 };

void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t value);
int digitalRead(uint8_t pin);
int analogRead(uint8_t pin);
void analogWrite(uint8_t pin, int value);
void delay(unsigned long milliseconds);
void delayMicroseconds(unsigned int microseconds);

struct HardwareSerial {
  void begin(unsigned long baud);
  size_t write(uint8_t byte);
  size_t print(const char *text);
  size_t println(int number);
};
extern HardwareSerial Serial;

void setup();
void loop();
#endif
