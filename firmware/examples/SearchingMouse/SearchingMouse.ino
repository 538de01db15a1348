// A mouse with three wall sensors and two motors that searches 16x16 cells, returns to the start, saves its map to
// EEPROM, and makes a speed run. Switched on again, it restores the map and makes a speed run at once; hold the button
// to search anew. Set the pins, the threshold and the times to those of your mouse.
#include <Arduino.h>
#include <EEPROM.h>
#include <labmouse_tiny.h>

const int BUTTON = 2;                                 // to ground
const int LEFT_SENSOR = A0, FRONT_SENSOR = A1, RIGHT_SENSOR = A2;
const int EMITTER = 12;
const int LEFT_PWM = 9, LEFT_REVERSE = 7, RIGHT_PWM = 10, RIGHT_REVERSE = 8;
const int THRESHOLD = 120;                            // more light above the ambient light than this is a wall
const int DUTY = 80;                                  // of 255
const unsigned long CELL_MS = 600, QUARTER_MS = 250;  // better: count encoder pulses

labmouse_tiny mouse;

uint8_t wall(int sensor) {
  const int dark = analogRead(sensor);
  digitalWrite(EMITTER, HIGH);
  delayMicroseconds(60);
  const int lit = analogRead(sensor);
  digitalWrite(EMITTER, LOW);
  return lit - dark > THRESHOLD;
}

void motors(bool leftReverse, bool rightReverse, unsigned long milliseconds) {
  digitalWrite(LEFT_REVERSE, leftReverse);
  digitalWrite(RIGHT_REVERSE, rightReverse);
  analogWrite(LEFT_PWM, DUTY);
  analogWrite(RIGHT_PWM, DUTY);
  delay(milliseconds);
  analogWrite(LEFT_PWM, 0);
  analogWrite(RIGHT_PWM, 0);
  delay(100);
}

void drive(labmouse_tiny_move move) {
  if (move == LABMOUSE_TINY_RIGHT || move == LABMOUSE_TINY_LOOK) motors(false, true, QUARTER_MS);
  if (move == LABMOUSE_TINY_LEFT) motors(true, false, QUARTER_MS);
  if (move == LABMOUSE_TINY_BACK) {
    motors(false, true, 2 * QUARTER_MS);
    labmouse_tiny_turned(&mouse, 2);  // this mouse turns in place of driving backwards
  }
  if (move != LABMOUSE_TINY_LOOK && move != LABMOUSE_TINY_END) motors(false, false, CELL_MS);
}

int putLetter(int letter) { return Serial.write(static_cast<uint8_t>(letter)); }
void writeByte(uint16_t address, uint8_t byte) { EEPROM.update(address, byte); }
uint8_t readByte(uint16_t address) { return EEPROM.read(address); }

// Drives until the run has ended.
labmouse_tiny_status run() {
  labmouse_tiny_move move = LABMOUSE_TINY_AHEAD;
  while (move != LABMOUSE_TINY_END) {
    labmouse_tiny_status status = labmouse_tiny_observe(&mouse, wall(LEFT_SENSOR), wall(FRONT_SENSOR), wall(RIGHT_SENSOR));
    if (status == LABMOUSE_TINY_OK) status = labmouse_tiny_decide(&mouse, &move);
    if (status != LABMOUSE_TINY_OK) return status;
    drive(move);
  }
  return LABMOUSE_TINY_OK;
}

// The mouse ended its search at the start, where it came from: it turns to head north again.
void faceNorth() {
  for (uint8_t heading = mouse.heading; heading % 4 != 0; ++heading) motors(false, true, QUARTER_MS);
}

void setup() {
  Serial.begin(115200);
  pinMode(BUTTON, INPUT_PULLUP);
  pinMode(EMITTER, OUTPUT);
  pinMode(LEFT_REVERSE, OUTPUT);
  pinMode(RIGHT_REVERSE, OUTPUT);
  labmouse_tiny_create(&mouse, 1);
  labmouse_tiny_status status = LABMOUSE_TINY_OK;
  if (digitalRead(BUTTON) == LOW || labmouse_tiny_restore(&mouse, readByte) != LABMOUSE_TINY_OK) {
    delay(2000);
    status = run();
    if (status == LABMOUSE_TINY_OK) labmouse_tiny_save(&mouse, writeByte);
    faceNorth();
  }
  if (status == LABMOUSE_TINY_OK) {
    delay(2000);
    labmouse_tiny_start(&mouse, 1);
    status = run();
  }
  labmouse_tiny_print(&mouse, putLetter);
  Serial.print("status ");
  Serial.println(static_cast<int>(status));
}

void loop() {}
