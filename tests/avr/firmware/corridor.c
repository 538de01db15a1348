/* Firmware for tests: a UKMARSbot that waits for its button, drives some cells straight on, and stops. It uses what
   firmware of such robots uses: interrupts of both encoders and of a timer, the ADC with the emitter on and off, PWM of
   timer 1, the function button, and the serial port. FAULT makes it fail after the last cell. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <stdint.h>

#ifndef CELLS
#define CELLS 3
#endif
#define ILLEGAL 1
#define JUMP 2
#define SLEEP 3
#define WRITE 4
#define FAR 5
#ifndef FAULT
#define FAULT 0
#endif

#define COUNT_UM 260L      /* travel of a wheel for a count */
#define CELL_UM 180000L
#define SPEED_UM 300L      /* in a millisecond */

static volatile int16_t steps[2]; /* since the last tick */
static volatile int32_t travel_um;
static volatile uint8_t driving;
static int16_t wanted_um[2], done_um[2];

/* The pins are A xor B and B; the sign is that of A before and B after. */
static void count(uint8_t wheel, uint8_t clock, uint8_t b) {
  static uint8_t last_a[2], last_b[2];
  const uint8_t a = clock ^ b;
  const int8_t step = (int8_t)((last_a[wheel] ^ b) - (a ^ last_b[wheel]));
  steps[wheel] += wheel == 0 ? -step : step;
  last_a[wheel] = a;
  last_b[wheel] = b;
}
ISR(INT0_vect) { count(0, PIND >> 2 & 1, PIND >> 4 & 1); }
ISR(INT1_vect) { count(1, PIND >> 3 & 1, PIND >> 5 & 1); }

static uint16_t read_adc(uint8_t channel) {
  ADMUX = _BV(REFS0) | channel;
  ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC)) {
  }
  return ADC;
}

/* What the emitter adds. */
static int16_t read_wall(uint8_t channel) {
  const int16_t dark = (int16_t)read_adc(channel);
  PORTB |= _BV(PB4);
  const int16_t lit = (int16_t)read_adc(channel);
  PORTB &= (uint8_t)~_BV(PB4);
  return lit - dark;
}

static void set_motor(uint8_t wheel, int16_t duty) {
  const uint8_t ahead = duty >= 0;
  const uint16_t share = (uint16_t)(ahead ? duty : -duty);
  if (wheel == 0) {
    if (ahead) PORTD |= _BV(PD7);
    else PORTD &= (uint8_t)~_BV(PD7);
    OCR1A = share > 255 ? 255 : share;
  } else {
    if (ahead) PORTB &= (uint8_t)~_BV(PB0);
    else PORTB |= _BV(PB0);
    OCR1B = share > 255 ? 255 : share;
  }
}

/* Each millisecond: drives the wheels at their speeds, and turns away from the nearer wall. */
ISR(TIMER2_COMPA_vect) {
  int16_t steer = 0;
  if (driving) {
    const int16_t right = read_wall(0), left = read_wall(2);
    if (right > 60 && left > 60) steer = (int16_t)((left - right) / 4);
    if (steer > 40) steer = 40;
    if (steer < -40) steer = -40;
  }
  for (uint8_t wheel = 0; wheel < 2; ++wheel) {
    const int16_t now = (int16_t)(steps[wheel] * COUNT_UM);
    steps[wheel] = 0;
    travel_um += now / 2;
    const int16_t aim = driving ? (int16_t)(SPEED_UM + (wheel == 0 ? steer : -steer)) : 0;
    wanted_um[wheel] = (int16_t)(wanted_um[wheel] + aim - now); /* position error */
    done_um[wheel] = (int16_t)((3 * done_um[wheel] + now) / 4);
    set_motor(wheel, (int16_t)(aim / 12 + (aim ? 12 : 0) + (aim - done_um[wheel]) / 16 + wanted_um[wheel] / 64));
  }
}

static void print(const char* text) {
  for (; *text; ++text) {
    while (!(UCSR0A & _BV(UDRE0))) {
    }
    UDR0 = (uint8_t)*text;
  }
}

static void fail(void) {
#if FAULT == ILLEGAL
  __asm__ volatile(".global illegal_here\nillegal_here: .word 0x0001");
#elif FAULT == JUMP
  ((void (*)(void))0x3000)();
#elif FAULT == FAR
  ((void (*)(void))0x7000)();
#elif FAULT == SLEEP
  cli();
  sleep_mode();
#elif FAULT == WRITE
  *(volatile uint8_t*)0x2000 = 1;
#endif
}

int main(void) {
  DDRB = _BV(PB0) | _BV(PB1) | _BV(PB2) | _BV(PB4);
  DDRD = _BV(PD6) | _BV(PD7);
  EICRA = _BV(ISC00) | _BV(ISC10); /* any edge */
  EIMSK = _BV(INT0) | _BV(INT1);
  TCCR1A = _BV(COM1A1) | _BV(COM1B1) | _BV(WGM10); /* phase correct, 8 bits, 31 kHz */
  TCCR1B = _BV(CS10);
  TCCR2A = _BV(WGM21);
  TCCR2B = _BV(CS22); /* clock / 64 */
  OCR2A = 249;
  TIMSK2 = _BV(OCIE2A);
  ADCSRA = _BV(ADEN) | _BV(ADPS2); /* clock / 16: 13 us */
  UBRR0 = 8;                       /* 115,200 baud */
  UCSR0B = _BV(TXEN0);
  print("ready\r\n");
  while (read_adc(6) < 800) {
  }
  while (read_adc(6) > 800) {
  }
  sei();
  print("go\r\n");
  driving = 1;
  for (;;) {
    cli();
    const int32_t travel = travel_um;
    sei();
    if (travel >= CELLS * CELL_UM - 9000) break; /* it needs 9 mm to stop */
  }
  driving = 0;
  PORTD |= _BV(PD6);
  print("done\r\n");
  fail();
  set_sleep_mode(SLEEP_MODE_IDLE);
  for (;;) sleep_mode(); /* the timer goes on */
}
