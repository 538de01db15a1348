// A UKMARSbot that follows the left wall, cell by cell, until its time is over. It needs nothing but the Arduino core, so it
// is built for the chip by avr-gcc, and for labmouse by ../CMakeLists.txt.
#include <Arduino.h>
#include <EEPROM.h>

const uint8_t LEFT_CLOCK = 2, RIGHT_CLOCK = 3, LEFT_B = 4, RIGHT_B = 5;
const uint8_t LEFT_DIRECTION = 7, RIGHT_DIRECTION = 8, LEFT_PWM = 9, RIGHT_PWM = 10, EMITTER = 12;
const uint8_t RIGHT_SENSOR = A0, FRONT_SENSOR = A1, LEFT_SENSOR = A2, BUTTON = A6;

const long COUNT_UM = 260;           // travel of a wheel for a count
const long CELL_UM = 180000;
const long QUARTER_TURN_UM = 59600;  // of each wheel
const int PERIOD_MS = 2;
const int SIDE_WALL = 60, FRONT_WALL = 150;  // readings beyond which there is a wall
const int CENTRED = 196;                     // reading of a side wall in the middle of a cell
const int FRONT_STOP = 700;                  // reading of a front wall in the middle of a cell

volatile int leftCount = 0, rightCount = 0;

void countLeft() {
  static bool lastA = false, lastB = false;
  const bool b = digitalRead(LEFT_B), a = digitalRead(LEFT_CLOCK) ^ b;
  leftCount -= int(lastA ^ b) - int(a ^ lastB);
  lastA = a;
  lastB = b;
}

void countRight() {
  static bool lastA = false, lastB = false;
  const bool b = digitalRead(RIGHT_B), a = digitalRead(RIGHT_CLOCK) ^ b;
  rightCount += int(lastA ^ b) - int(a ^ lastB);
  lastA = a;
  lastB = b;
}

int left, front, right;  // what the emitter adds to each sensor

void readWalls() {
  left = -analogRead(LEFT_SENSOR);
  front = -analogRead(FRONT_SENSOR);
  right = -analogRead(RIGHT_SENSOR);
  digitalWrite(EMITTER, HIGH);
  left += analogRead(LEFT_SENSOR);
  front += analogRead(FRONT_SENSOR);
  right += analogRead(RIGHT_SENSOR);
  digitalWrite(EMITTER, LOW);
}

void setMotor(uint8_t pwm, uint8_t direction, bool high, int duty) {
  digitalWrite(direction, (duty >= 0) == high ? HIGH : LOW);
  analogWrite(pwm, constrain(abs(duty), 0, 255));
}

long leftUm, rightUm;  // travel since the move began

// A wheel that should have gone `wanted` and should go `speed`, in µm and µm/ms: its duty.
int duty(long wanted, long gone, long speed) {
  const long error = wanted - gone;
  const long ahead = speed / 12 + (speed > 0 ? 12 : speed < 0 ? -12 : 0);
  return int(ahead + constrain(error / 100, -60L, 60L));
}

// Drives both wheels so far, one period after the other; -1 for the left wheel turns to the left.
void drive(long distance, int leftSign, bool steers) {
  const long farthest = distance + 15000;
  long wanted = 0, speed = 0, aside = 0;
  unsigned long next = millis() + PERIOD_MS;
  int rest = 0;
  leftUm = rightUm = 0;
  while (rest < 50) {
    while ((long)(millis() - next) < 0) {
    }
    next += PERIOD_MS;
    noInterrupts();
    const int leftSteps = leftCount, rightSteps = rightCount;
    leftCount = rightCount = 0;
    interrupts();
    leftUm += leftSteps * COUNT_UM;
    rightUm += rightSteps * COUNT_UM;
    readWalls();
    if (steers) {
      // Near its end, a wall ahead says where the middle of the cell is.
      if (front > FRONT_STOP && distance - wanted < 20000) distance = wanted;
      if (front > FRONT_WALL && front < FRONT_STOP && distance - wanted < 2000 && distance < farthest) distance += 500;
      int off = 0;
      if (left > SIDE_WALL && right > SIDE_WALL) off = left - right;
      else if (left > SIDE_WALL) off = 2 * (left - CENTRED);
      else if (right > SIDE_WALL) off = 2 * (CENTRED - right);
      if (speed > 0) aside += constrain(off, -60, 60) * speed / 600;
    }
    const long top = steers ? 300 : 150, to_go = distance - wanted;
    speed = min(min(speed + 2L * PERIOD_MS, top), max(to_go / 80, 20L));
    wanted = min(wanted + speed * PERIOD_MS, distance);
    if (wanted >= distance) {
      speed = 0;
      ++rest;
    }
    setMotor(LEFT_PWM, LEFT_DIRECTION, true, duty(leftSign * wanted + aside, leftUm, leftSign * speed));
    setMotor(RIGHT_PWM, RIGHT_DIRECTION, false, duty((steers ? 1 : -leftSign) * wanted - aside, rightUm, (steers ? 1 : -leftSign) * speed));
  }
}

void turnLeft() { drive(QUARTER_TURN_UM, -1, false); }
void turnRight() { drive(QUARTER_TURN_UM, 1, false); }

void setup() {
  Serial.begin(115200);
  pinMode(EMITTER, OUTPUT);
  pinMode(LEFT_DIRECTION, OUTPUT);
  pinMode(RIGHT_DIRECTION, OUTPUT);
  pinMode(LEFT_PWM, OUTPUT);
  pinMode(RIGHT_PWM, OUTPUT);
  attachInterrupt(digitalPinToInterrupt(LEFT_CLOCK), countLeft, CHANGE);
  attachInterrupt(digitalPinToInterrupt(RIGHT_CLOCK), countRight, CHANGE);
  const uint8_t starts = EEPROM.read(0) + 1;  // an empty EEPROM has 255
  EEPROM.write(0, starts);
  Serial.print(F("start "));
  Serial.println(starts);
  while (analogRead(BUTTON) < 800) {
  }
  while (analogRead(BUTTON) > 800) {
  }
}

void loop() {
  readWalls();
  if (left < SIDE_WALL) turnLeft();
  else if (front > FRONT_WALL && right < SIDE_WALL) turnRight();
  else if (front > FRONT_WALL) {
    turnRight();
    turnRight();
  }
  drive(CELL_UM, 1, true);
}
