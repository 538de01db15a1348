/* Prints what a real robot sees, as the lines that `labmouse live` draws: docs/reference/protocols.md. C99 and C++11.
 *
 *   static void put(char letter) { Serial.write(letter); }
 *   struct labmouse_stream robot = {put, 0};
 *   labmouse_start(&robot);                       once, when the robot is switched on
 *   labmouse_cell(&robot, x, y, 'N', 1, 0, -1);   walls left, ahead and right: 1 closed, 0 open, -1 not seen
 *   labmouse_number(&robot, "batt", 7900);        any number of fields, none of them required
 *   labmouse_end(&robot);                         "3 4 N 10? batt=7900 *67" and a line feed
 */
#ifndef LABMOUSE_STREAM_H
#define LABMOUSE_STREAM_H
#include <stdint.h>

struct labmouse_stream {
  void (*put)(char letter); /* sends one character */
  uint8_t sum;              /* exclusive or of the characters of this line; 0 at first */
};

static inline void labmouse_put(struct labmouse_stream *stream, char letter) {
  stream->sum ^= (uint8_t)letter;
  stream->put(letter);
}
static inline void labmouse_put_text(struct labmouse_stream *stream, const char *text) {
  for (; *text; ++text) labmouse_put(stream, *text > ' ' && *text < 127 ? *text : '_');
}
static inline void labmouse_put_number(struct labmouse_stream *stream, int32_t value) {
  char digits[10];
  uint8_t count = 0;
  uint32_t rest = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
  if (value < 0) labmouse_put(stream, '-');
  do digits[count++] = (char)('0' + rest % 10u);
  while ((rest /= 10u) != 0);
  while (count > 0) labmouse_put(stream, digits[--count]);
}
/* A name and the numbers of a field, such as ir=12,840,-3; its text, such as state=search. */
static inline void labmouse_numbers(struct labmouse_stream *stream, const char *name, const int32_t *values,
                                    uint8_t count) {
  uint8_t i;
  labmouse_put(stream, ' ');
  labmouse_put_text(stream, name);
  for (i = 0; i < count; ++i) labmouse_put(stream, i ? ',' : '='), labmouse_put_number(stream, values[i]);
}
static inline void labmouse_number(struct labmouse_stream *stream, const char *name, int32_t value) {
  labmouse_numbers(stream, name, &value, 1);
}
static inline void labmouse_text(struct labmouse_stream *stream, const char *name, const char *text) {
  labmouse_put(stream, ' ');
  labmouse_put_text(stream, name);
  labmouse_put(stream, '=');
  labmouse_put_text(stream, text);
}
/* Ends a line with its checksum. */
static inline void labmouse_end(struct labmouse_stream *stream) {
  const char *const digits = "0123456789abcdef";
  uint8_t sum = (uint8_t)(stream->sum ^ ' '); /* the space before the star counts */
  stream->put(' '), stream->put('*'), stream->put(digits[sum >> 4]), stream->put(digits[sum & 15]), stream->put('\n');
  stream->sum = 0;
}
/* Says that the robot has started anew; ends what was left of a line before. */
static inline void labmouse_start(struct labmouse_stream *stream) {
  stream->put('\n'), stream->sum = 0;
  labmouse_put_text(stream, "start");
  labmouse_end(stream);
}
static inline void labmouse_cell(struct labmouse_stream *stream, int x, int y, char heading, int left, int ahead,
                                 int right) {
  labmouse_put_number(stream, x), labmouse_put(stream, ' '), labmouse_put_number(stream, y), labmouse_put(stream, ' ');
  labmouse_put(stream, heading), labmouse_put(stream, ' ');
  labmouse_put(stream, left < 0 ? '?' : left ? '1' : '0'), labmouse_put(stream, ahead < 0 ? '?' : ahead ? '1' : '0');
  labmouse_put(stream, right < 0 ? '?' : right ? '1' : '0');
}
#endif
