/* Firmware for tests: writes what its pins read to the serial port, every two milliseconds: the sensor at A0 dark and lit,
   those at A1 and A2 lit, the battery, the button, and what both encoders have counted. It drives its motors in three
   ways, one after the other. */
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <stdint.h>
#include <util/delay.h>

static volatile int16_t counts[2];
static uint8_t letter_of_start EEMEM = 'B';

static void count(uint8_t wheel, uint8_t a, uint8_t b) {
  static uint8_t last_a[2], last_b[2];
  const int8_t step = (int8_t)((last_a[wheel] ^ b) - (a ^ last_b[wheel]));
  counts[wheel] += wheel == 0 ? -step : step;
  last_a[wheel] = a;
  last_b[wheel] = b;
}

#ifdef QUADRATURE
ISR(PCINT1_vect) { count(0, PINC >> 3 & 1, PINC >> 4 & 1); }
#else
ISR(INT0_vect) { count(0, (PIND >> 2 ^ PIND >> 4) & 1, PIND >> 4 & 1); }
#endif
ISR(INT1_vect) { count(1, (PIND >> 3 ^ PIND >> 5) & 1, PIND >> 5 & 1); }

static uint16_t read_adc(uint8_t channel) {
  ADMUX = _BV(REFS0) | channel;
  ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC)) {
  }
  return ADC;
}

static void put(char letter) {
  while (!(UCSR0A & _BV(UDRE0))) {
  }
  UDR0 = (uint8_t)letter;
}

static void print(int16_t number) {
  char digits[6];
  uint8_t size = 0;
  if (number < 0) put('-');
  uint16_t rest = (uint16_t)(number < 0 ? -number : number);
  do digits[size++] = (char)('0' + rest % 10);
  while (rest /= 10);
  while (size) put(digits[--size]);
  put(' ');
}

int main(void) {
  DDRB = _BV(PB0) | _BV(PB1) | _BV(PB2) | _BV(PB4) | _BV(PB5);
  DDRD = _BV(PD6) | _BV(PD7);
  EICRA = _BV(ISC00) | _BV(ISC10);
#ifdef QUADRATURE
  EIMSK = _BV(INT1);
  PCICR = _BV(PCIE1);
  PCMSK1 = _BV(PCINT11) | _BV(PCINT12);
#else
  EIMSK = _BV(INT0) | _BV(INT1);
#endif
  ADCSRA = _BV(ADEN) | _BV(ADPS2);
  UBRR0 = 0; /* a million bits in a second */
  UCSR0B = _BV(TXEN0);
  put((char)eeprom_read_byte(&letter_of_start));
  put('\n');
  /* The left motor ahead, the right one backwards; phase correct, 8 bits. */
  PORTD |= _BV(PD7);
  PORTB |= _BV(PB0);
  TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(WGM10);
  TCCR1B = _BV(CS10);
  OCR1A = 64;
  OCR1B = 128;
  sei();
  for (uint8_t round = 0;; round += round < 255) {
    if (round == 4) { /* fast, 10 bits, the right one inverted */
      TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(COM1B0) | _BV(WGM11) | _BV(WGM10);
      TCCR1B = _BV(WGM12) | _BV(CS10);
      OCR1A = 511;
      OCR1B = 255;
    }
    if (round == 8) { /* no PWM: full ahead, and off */
      TCCR1A = 0;
      PORTB |= _BV(PB1);
      PORTB &= (uint8_t)~_BV(PB2);
    }
    if (round == 8) PORTD |= _BV(PD6); /* a signal */
    const int16_t dark = (int16_t)read_adc(0);
    PORTB |= _BV(PB4);
    const int16_t lit = (int16_t)read_adc(0), ahead = (int16_t)read_adc(1), left = (int16_t)read_adc(2);
    PORTB &= (uint8_t)~_BV(PB4);
    print(dark);
    print(lit);
    print(ahead);
    print(left);
    print((int16_t)read_adc(7));
    print((int16_t)read_adc(6));
    cli();
    const int16_t now[2] = {counts[0], counts[1]};
    sei();
    print(now[0]);
    print(now[1]);
    put('\n');
    _delay_us(1300);
  }
}
