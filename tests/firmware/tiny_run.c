/* Searches every maze of mazes.h with firmware/labmouse_tiny.h, makes the speed run, and prints a line for each: its
 * decisions, a checksum of all moves, and on a chip also the cycles of all decisions and of the longest one. The last
 * line has the bytes of the map, and on a chip those of the stack. scripts/firmware writes mazes.h and runs this. */
#include <stdint.h>

#include "labmouse_tiny.h"

#ifdef __AVR__
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <avr/sleep.h>

/* Timer 1 counts every eighth cycle: a decision is far shorter than its 65,536 counts. */
static void timer_start(void) { TCNT1 = 0; }
static uint32_t timer_cycles(void) { return (uint32_t)TCNT1 * 8; }
static int print(int letter) {
  while (!(UCSR0A & 1 << UDRE0)) continue;
  UDR0 = (uint8_t)letter;
  return letter;
}

/* Memory between the variables and the stack is painted; what has kept its colour was never used. */
extern uint8_t _end;
#define COLOUR 0xC5
static void paint(void) {
  volatile uint8_t *byte;
  for (byte = &_end; byte < (volatile uint8_t *)SP - 8; ++byte) *byte = COLOUR;
}
static uint16_t stack_used(void) {
  const volatile uint8_t *byte = &_end;
  while (*byte == COLOUR) ++byte;
  return (uint16_t)(RAMEND + 1 - (uint16_t)byte);
}
static void begin(void) {
  paint();
  TCCR1B = 1 << CS11;
  UCSR0B = 1 << TXEN0;
}
static int end(void) {
  while (!(UCSR0A & 1 << UDRE0)) continue;
  cli();
  sleep_enable();
  sleep_cpu();
  return 0;
}
#else
#include <stdio.h>
#define PROGMEM
#define pgm_read_byte(address) (*(address))
static void timer_start(void) {}
static uint32_t timer_cycles(void) { return 0; }
static int print(int letter) { return putchar(letter); }
static uint16_t stack_used(void) { return 0; }
static void begin(void) {}
static int end(void) { return 0; }
#endif

#include "mazes.h" /* MAZES; mazes[i][y][x], 1 wall north, 2 east, 4 south, 8 west; goals[i][2], one cell each */

static void print_number(uint32_t number) {
  char digits[10];
  uint8_t count = 0;
  do digits[count++] = (char)('0' + number % 10);
  while ((number /= 10) != 0);
  while (count > 0) print(digits[--count]);
}

static struct labmouse_tiny mouse;

static uint8_t wall(uint8_t maze, uint8_t quarters) {
  const uint8_t side = (uint8_t)(mouse.heading + quarters) & 3u;
  return (uint8_t)(pgm_read_byte(&mazes[maze][mouse.y][mouse.x]) >> side & 1u);
}

/* Of the present maze. */
static uint32_t cycles, most;
static uint16_t decisions, sum;

static enum labmouse_tiny_status run(uint8_t maze) {
  enum labmouse_tiny_move move = LABMOUSE_TINY_AHEAD;
  while (move != LABMOUSE_TINY_END) {
    enum labmouse_tiny_status status = labmouse_tiny_observe(&mouse, wall(maze, 3), wall(maze, 0), wall(maze, 1));
    uint32_t time;
    if (status != LABMOUSE_TINY_OK) return status;
    timer_start();
    status = labmouse_tiny_decide(&mouse, &move);
    time = timer_cycles();
    if (status != LABMOUSE_TINY_OK) return status;
    cycles += time;
    if (time > most) most = time;
    ++decisions;
    sum = labmouse_tiny_checksum(sum, (uint8_t)move);
  }
  return LABMOUSE_TINY_OK;
}

int main(void) {
  uint8_t maze;
  begin();
  for (maze = 0; maze < MAZES; ++maze) {
    uint8_t goal[1][2];
    enum labmouse_tiny_status status;
    cycles = most = 0;
    decisions = sum = 0;
    goal[0][0] = pgm_read_byte(&goals[maze][0]);
    goal[0][1] = pgm_read_byte(&goals[maze][1]);
    labmouse_tiny_create(&mouse, 1);
    labmouse_tiny_set_goals(&mouse, (const uint8_t(*)[2])goal, 1);
    status = run(maze);
    if (status == LABMOUSE_TINY_OK) status = labmouse_tiny_start(&mouse, 1);
    if (status == LABMOUSE_TINY_OK) status = run(maze);
    print_number(status), print(' ');
    print_number(decisions), print(' '), print_number(sum), print(' ');
    print_number(cycles), print(' '), print_number(most), print('\n');
  }
  print_number(sizeof mouse), print(' '), print_number(stack_used()), print('\n');
  return end();
}
