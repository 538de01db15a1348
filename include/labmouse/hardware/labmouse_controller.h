/* A controller for labmouse in C: the whole program of a mouse, from what its sensors read to what its motors do.
 *
 * Define `const struct labmouse_controller labmouse_controller`. If LABMOUSE_CONTROLLER_MAIN is defined, this header
 * has a main() for it, which speaks labmouse's protocol over standard input and output, so that it can race.
 * docs/reference/protocols.md shows how.
 *
 * C99 and C++, with the standard library alone. Lengths are in mm, angles in rad to the left, x counts eastwards and y
 * northwards from the south-western corner of the maze.
 */
#ifndef LABMOUSE_CONTROLLER_H
#define LABMOUSE_CONTROLLER_H

/* NOLINTBEGIN: C has other habits than C++. */
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  LABMOUSE_FULL = 32767,       /* full duty: all that the battery can give */
  LABMOUSE_LONGEST_BATCH = 64, /* ms */
  LABMOUSE_MOST_GOALS = 1024,  /* cells */
  LABMOUSE_MOST_INFRARED = 16, /* sensors */
  LABMOUSE_MOST_RANGERS = 8    /* ToF sensors */
};

/** A direction in the maze, clockwise from north. */
enum labmouse_heading { LABMOUSE_NORTH, LABMOUSE_EAST, LABMOUSE_SOUTH, LABMOUSE_WEST };

/** Sensor readings at a tick, in the units given by the numbers of the robot. */
struct labmouse_sense {
  uint32_t tick;           /* ms since the mouse was switched on */
  int32_t counts[2];       /* of the encoders since then: left, right */
  int16_t gyro;            /* to the left */
  int16_t acceleration[2]; /* ahead, to the left */
  /* Of each infrared sensor, in the order of labmouse_robot.infrared: right, right ahead, left, left ahead, if the file
     of the robot has pairs of them. */
  int16_t infrared[LABMOUSE_MOST_INFRARED];
  /* Of each ToF sensor, in the order of labmouse_robot.ranger: mm to what it looks at; 0 where nothing is seen. */
  uint16_t ranges[LABMOUSE_MOST_RANGERS];
  uint16_t ranges_new[LABMOUSE_MOST_RANGERS]; /* 1 where that was read just now */
  uint16_t millivolts;                        /* of the battery */
};

/** What the controller reports beside its duties. labmouse detects where runs begin and end; this is their purpose. */
enum labmouse_word {
  LABMOUSE_DRIVE,  /* nothing */
  LABMOUSE_FAST,   /* the next run is a speed run */
  LABMOUSE_GOAL,   /* ends this run, if it has been in a goal; what follows is the way home, not a part of the run */
  LABMOUSE_CARRY,  /* carry the mouse to the start; the duties are ignored */
  LABMOUSE_FORFEIT /* end the contest; the duties are ignored */
};

/** The controller's output until the next tick: duties from -LABMOUSE_FULL to LABMOUSE_FULL, and a labmouse_word; any
   other word counts as LABMOUSE_FORFEIT. */
struct labmouse_drive {
  int32_t left, right, word;
};

/* What the robot is built of, as in its file (docs/reference/files.md): body.front, in mm, is body_front. */
#define LABMOUSE_ROBOT_NUMBERS(number)                                                                                \
  number(body, front) number(body, back) number(body, half_width) number(body, half_track) number(body, rounding)     \
  number(body, slip_stiffness) number(body, grip) number(body, downforce) number(body, yaw_moment)                    \
  number(motors, drive_gain) number(motors, drive_time) number(motors, drive_dead_zone) number(motors, turn_gain)     \
  number(motors, turn_time) number(motors, turn_dead_zone) number(motors, turning) number(motors, rotating)           \
  number(motors, sag) number(motors, discharge) number(motors, volts) number(motors, period)                          \
  number(motors, left) number(motors, right) number(motors, dead_time) number(motors, coast)                          \
  number(sensors, count) number(sensors, count_bits) number(sensors, gyro_step) number(sensors, gyro_most)            \
  number(sensors, acceleration_step)                                                                                  \
  number(sensors, side_ahead) number(sensors, side_aside) number(sensors, side_angle) number(sensors, front_ahead)    \
  number(sensors, front_aside) number(sensors, front_angle) number(sensors, infrared_gain)                            \
  number(sensors, infrared_fall) number(sensors, infrared_most) number(sensors, infrared_footprint)                   \
  number(sensors, ranger_ahead) number(sensors, ranger_reach) number(sensors, ranger_period)                          \
  number(noise, gyro_bias) number(noise, ripple) number(noise, ripple_length) number(noise, encoder)                  \
  number(noise, gyro) number(noise, gyro_walk) number(noise, acceleration) number(noise, infrared)                    \
  number(noise, infrared_share) number(noise, infrared_memory) number(noise, ranger_rest) number(noise, ranger)       \
  number(noise, shaking) number(noise, shaking_speed) number(noise, shaking_pitch) number(noise, shaking_loss)        \
  number(variation, motor_gain) number(variation, battery) number(variation, slip_stiffness) number(variation, grip)  \
  number(variation, dust) number(variation, encoder_scale) number(variation, gyro_scale)                              \
  number(variation, acceleration_bias) number(variation, infrared_gain) number(variation, reflectance)                \
  number(variation, maze_reflectance) number(variation, post_shift) number(variation, ambient)                        \
  number(variation, ambient_drift) number(variation, floor_steps) number(variation, floor_turn)                       \
  number(variation, floor_shift) number(variation, floor_tilt) number(variation, placement)                           \
  number(variation, placement_turn)

/** An infrared sensor: mm ahead of the axle and to the left of the middle, and rad to the left of ahead. */
struct labmouse_infrared {
  double ahead, aside, angle;
  double gain;      /* counts, of a wall as far as the side or the front of a cell is from its middle */
  double fall;      /* mm over which readings fall to 1/e; 0: they fall with the square of the distance */
  double most;      /* counts */
  double footprint; /* mm */
  double group;     /* the groups are lit one after the other, each ms */
  double latency;   /* ms */
};
/** A ToF sensor, placed in the same way. */
struct labmouse_ranger {
  double ahead, aside, angle;
  double reach;  /* mm */
  double period; /* ms */
};

#define LABMOUSE_ROBOT_FIELD(section, name) double section##_##name;
/** The numbers of the robot. Those of sensors that it lacks are 0. Those of pairs of infrared sensors (side, front) and
   of a ToF sensor that looks ahead are 0, too, where its file lists sensors one by one; the lists have all sensors of
   any robot. */
struct labmouse_robot {
  LABMOUSE_ROBOT_NUMBERS(LABMOUSE_ROBOT_FIELD)
  int infrared_sensors, range_sensors; /* how many */
  struct labmouse_infrared infrared[LABMOUSE_MOST_INFRARED];
  struct labmouse_ranger ranger[LABMOUSE_MOST_RANGERS];
};
#undef LABMOUSE_ROBOT_FIELD

/** A cell of the maze. */
struct labmouse_cell {
  int x, y; /* column and row, from 0 */
};

/** What it knows before the mouse is put into the maze. Times are in ms. */
struct labmouse_briefing {
  int width, height; /* of the maze, in cells */
  struct labmouse_cell start;
  enum labmouse_heading start_heading;
  int goals; /* how many */
  struct labmouse_cell goal[LABMOUSE_MOST_GOALS];
  double time_limit;
  int runs;              /* most runs from the start */
  int gate_to_gate;      /* 1 where the clock of a run goes from gate to gate, 0 from rest to the middle of the goal */
  int maze_time_divisor; /* 1/this of the time in the maze before a run is added to it; 0: none */
  double touch_penalty, untouched_bonus;
  double handling; /* time to carry the mouse to the start */
  uint64_t seed;   /* for random numbers of its own */
  double cell;     /* the side of a cell, mm */
  struct labmouse_robot robot;
};

/** A controller: its functions and its batch. Several contests may go on at once, each with its own memory. */
struct labmouse_controller {
  /** Begins a contest.
   * @param briefing the maze's size, start and goals, the rules and the robot; valid until `end` returns.
   * @return the contest's memory, passed to the other functions; may be null. */
  void* (*begin)(const struct labmouse_briefing* briefing);
  /** Called for each tick of 1 ms, in order.
   * @param memory what `begin` returned.
   * @param sense the readings of this tick, valid during the call.
   * @return the duties until the next tick, and a word. */
  struct labmouse_drive (*tick)(void* memory, const struct labmouse_sense* sense);
  /** The mouse was carried to the start, where it stands as in the beginning.
   * @param memory what `begin` returned.
   * @param crashed 1 after a crash, 0 at its request. */
  void (*carried)(void* memory, int crashed);
  /** The contest has ended: frees the memory.
   * @param memory what `begin` returned. */
  void (*end)(void* memory);
  /** Number of ticks that main() handles at a time, 1 to LABMOUSE_LONGEST_BATCH. More are faster to simulate, but
   * duties take effect later, by batch - 1 ms: with 1 at once, with 8 after 7 ms. */
  int batch;
};

/** Your program defines it. */
extern const struct labmouse_controller labmouse_controller;

/* To replace parts of labmouse's own controller: that controller drives the moves, and calls your parts in place of its
   own, at each tick, or at each tick of its period (labmouse_robot.motors_period). They are linked with labmouse;
   main() below is for whole controllers. */

/** A direction: the cosine and sine of its angle to the left of east. */
struct labmouse_direction {
  double cosine, sine;
};

/** Where the mouse should be at a tick, and how it should move there. */
struct labmouse_target {
  double x, y;
  struct labmouse_direction ahead; /* the direction in which it should move */
  double speed;                    /* mm/s, below 0 backwards */
  double speeding;                 /* mm/s^2 */
  double turning;                  /* rad/s */
  double twisting;                 /* rad/s^2 */
};

/** The estimated state of the mouse. */
struct labmouse_estimate {
  double x, y;
  struct labmouse_direction ahead; /* the direction in which it points */
  double slip;                     /* slip angle in rad, from there to the direction of motion */
  double speed;                    /* mm/s */
  double turning;                  /* rad/s */
  double covariance[3][3];         /* of x, y in mm and the angle in rad */
};

/** Evidence about the walls to its left, ahead and to its right: the log-likelihood ratio of the readings, wall against
   no wall, in eighths of a nat, -127 to 127. */
struct labmouse_evidence {
  int left, ahead, right;
};

/** Duties from -LABMOUSE_FULL to LABMOUSE_FULL. */
struct labmouse_duties {
  int32_t left, right;
};

/** The parts; any function may be null. If `estimate`, `evidence` or `follow` is null, labmouse's own part is used. */
struct labmouse_parts {
  /** Begins a contest.
   * @param briefing as in labmouse_controller.
   * @return the contest's memory, passed to the other functions; may be null. Without this function it is null. */
  void* (*begin)(const struct labmouse_briefing* briefing);
  /** The estimator: the mouse was put at about this position, and is at rest.
   * @param memory what `begin` returned.
   * @param x mm eastwards from the south-western corner of the maze.
   * @param y mm northwards from there.
   * @param ahead the direction in which it points. */
  void (*put)(void* memory, double x, double y, struct labmouse_direction ahead);
  /** The estimator: called for each tick, in order.
   * @param memory what `begin` returned.
   * @param sense the readings of this tick, valid during the call.
   * @param target where the mouse should be at this tick, valid during the call.
   * @return the state of the mouse. Invalid numbers are ignored: the estimate stays. */
  struct labmouse_estimate (*estimate)(void* memory, const struct labmouse_sense* sense,
                                       const struct labmouse_target* target);
  /** The wall detector: chooses the cell to read from now on.
   * @param memory what `begin` returned.
   * @param cell the cell.
   * @param heading that in which the mouse sees it. */
  void (*look)(void* memory, struct labmouse_cell cell, enum labmouse_heading heading);
  /** The wall detector: called for each tick, after the estimate.
   * @param memory what `begin` returned.
   * @param sense the readings of this tick, valid during the call.
   * @param estimate the state of the mouse, valid during the call. */
  void (*read)(void* memory, const struct labmouse_sense* sense, const struct labmouse_estimate* estimate);
  /** The wall detector: asks for what was read of the cell so far.
   * @param memory what `begin` returned.
   * @param estimate the state of the mouse, valid during the call.
   * @return evidence of three walls of the cell, as seen in the heading of `look`; cut to -127 to 127. */
  struct labmouse_evidence (*evidence)(void* memory, const struct labmouse_estimate* estimate);
  /** The tracker: the mouse was put down, at rest.
   * @param memory what `begin` returned. */
  void (*rest)(void* memory);
  /** The tracker: called for each tick, last.
   * @param memory what `begin` returned.
   * @param sense the readings of this tick, valid during the call.
   * @param target where the mouse should be at this tick, valid during the call.
   * @param estimate the state of the mouse, valid during the call.
   * @return the duties until the next tick, cut to -LABMOUSE_FULL to LABMOUSE_FULL. */
  struct labmouse_duties (*follow)(void* memory, const struct labmouse_sense* sense,
                                   const struct labmouse_target* target, const struct labmouse_estimate* estimate);
  /** The contest has ended: frees the memory.
   * @param memory what `begin` returned; null without `begin`. */
  void (*end)(void* memory);
};

#ifdef __cplusplus
}
#endif

#ifdef LABMOUSE_CONTROLLER_MAIN

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Reads a line of any length from standard input. Exits with 1 if there is no memory for it.
 * @return the line without its end, valid until the next call; null at the end of the input. */
static char* labmouse_read_line(void) {
  static char* line = NULL;
  static size_t room = 0;
  size_t size = 0;
  do {
    if (room < size + 256) {
      char* more = (char*)realloc(line, room = 2 * size + 8192);
      if (more == NULL) exit(1);
      line = more;
    }
    if (fgets(line + size, (int)(room - size), stdin) == NULL) return size > 0 ? line : NULL;
    size += strlen(line + size);
  } while (size == 0 || line[size - 1] != '\n');
  line[strcspn(line, "\r\n")] = '\0';
  return line;
}

/** Stores numbers from a text.
 * @param text numbers separated by spaces.
 * @param to an array of at least `count` elements; those that the text lacks become 0.
 * @param count how many. */
static void labmouse_take_numbers(const char* text, double* to, int count) {
  char* end = NULL;
  int i;
  for (i = 0; i < count; ++i) {
    to[i] = strtod(text, &end);
    text = end;
  }
}

/** Stores a line of the briefing.
 * @param line without its end; unknown lines are ignored.
 * @param told the briefing so far. */
static void labmouse_be_told(const char* line, struct labmouse_briefing* told) {
#define LABMOUSE_ROBOT_NAME(section, name) {#section "." #name, offsetof(struct labmouse_robot, section##_##name)},
  static const struct {
    const char* name;
    size_t place;
  } numbers[] = {LABMOUSE_ROBOT_NUMBERS(LABMOUSE_ROBOT_NAME)};
#undef LABMOUSE_ROBOT_NAME
  static const char headings[] = "nesw";
  char word[64] = "", name[16] = "";
  int x = 0, y = 0;
  size_t i;
  const char* rest = strchr(line, ' ');
  if (rest == NULL || (size_t)(rest - line) >= sizeof word) return;
  memcpy(word, line, (size_t)(rest - line));
  if (strcmp(word, "size") == 0) sscanf(rest, "%d %d", &told->width, &told->height);
  if (strcmp(word, "start") == 0 && sscanf(rest, "%d %d %15s", &told->start.x, &told->start.y, name) == 3 &&
      strchr(headings, name[0]) != NULL)
    told->start_heading = (enum labmouse_heading)(strchr(headings, name[0]) - headings);
  if (strcmp(word, "goal") == 0 && told->goals < LABMOUSE_MOST_GOALS && sscanf(rest, "%d %d", &x, &y) == 2) {
    told->goal[told->goals].x = x;
    told->goal[told->goals++].y = y;
  }
  if (strcmp(word, "time_limit") == 0) told->time_limit = strtod(rest, NULL);
  if (strcmp(word, "runs") == 0) told->runs = atoi(rest);
  if (strcmp(word, "clock") == 0) told->gate_to_gate = strcmp(rest, " gate") == 0;
  if (strcmp(word, "maze_time_divisor") == 0) told->maze_time_divisor = atoi(rest);
  if (strcmp(word, "touch_penalty") == 0) told->touch_penalty = strtod(rest, NULL);
  if (strcmp(word, "untouched_bonus") == 0) told->untouched_bonus = strtod(rest, NULL);
  if (strcmp(word, "handling") == 0) told->handling = strtod(rest, NULL);
  if (strcmp(word, "seed") == 0) told->seed = strtoull(rest, NULL, 10);
  if (strcmp(word, "cell") == 0) told->cell = strtod(rest, NULL);
  if (strcmp(word, "infrared") == 0 && told->robot.infrared_sensors < LABMOUSE_MOST_INFRARED)
    labmouse_take_numbers(rest, &told->robot.infrared[told->robot.infrared_sensors++].ahead, 9);
  if (strcmp(word, "ranger") == 0 && told->robot.range_sensors < LABMOUSE_MOST_RANGERS)
    labmouse_take_numbers(rest, &told->robot.ranger[told->robot.range_sensors++].ahead, 5);
  for (i = 0; i < sizeof numbers / sizeof numbers[0]; ++i)
    if (strcmp(word, numbers[i].name) == 0) *(double*)((char*)&told->robot + numbers[i].place) = strtod(rest, NULL);
}

/** Takes the readings of a tick from the front of a text.
 * @param robot says how many sensors there are.
 * @param text is moved behind what was read.
 * @param sense is overwritten.
 * @return 1; 0 if the text has no whole tick. */
static int labmouse_take_sense(const struct labmouse_robot* robot, char** text, struct labmouse_sense* sense) {
  long numbers[7 + LABMOUSE_MOST_INFRARED + 2 * LABMOUSE_MOST_RANGERS] = {0};
  const int infrared = robot->infrared_sensors, ranges = robot->range_sensors, all = 7 + infrared + 2 * ranges;
  char* at = *text;
  int i;
  for (i = 0; i < all; ++i) {
    numbers[i] = strtol(at, text, 10);
    if (at == *text) return 0;
    at = *text;
  }
  memset(sense, 0, sizeof *sense);
  sense->tick = (uint32_t)numbers[0];
  for (i = 0; i < 2; ++i) sense->counts[i] = (int32_t)numbers[1 + i];
  sense->gyro = (int16_t)numbers[3];
  for (i = 0; i < 2; ++i) sense->acceleration[i] = (int16_t)numbers[4 + i];
  for (i = 0; i < infrared; ++i) sense->infrared[i] = (int16_t)numbers[6 + i];
  for (i = 0; i < ranges; ++i) {
    sense->ranges[i] = (uint16_t)numbers[6 + infrared + 2 * i];
    sense->ranges_new[i] = (uint16_t)numbers[7 + infrared + 2 * i];
  }
  sense->millivolts = (uint16_t)numbers[all - 1];
  return 1;
}

/** Answers all ticks of a line with a line on standard output. If these are less than a batch, the last answer is
 * repeated to fill it.
 * @param robot says how many sensors there are.
 * @param memory of the contest.
 * @param text the readings of up to LABMOUSE_LONGEST_BATCH ticks.
 * @param batch the least number of ticks in the answer. */
static void labmouse_answer(const struct labmouse_robot* robot, void* memory, char* text, int batch) {
  static const char* const words[] = {"drive", "fast", "goal", "carry", "forfeit"};
  struct labmouse_sense sense;
  struct labmouse_drive said[LABMOUSE_LONGEST_BATCH];
  int word = LABMOUSE_DRIVE, count = 0, i;
  while (count < LABMOUSE_LONGEST_BATCH && labmouse_take_sense(robot, &text, &sense)) {
    said[count] = labmouse_controller.tick(memory, &sense);
    if (said[count].word != LABMOUSE_DRIVE) word = said[count].word;
    ++count;
  }
  for (; count > 0 && count < batch && count < LABMOUSE_LONGEST_BATCH; ++count) said[count] = said[count - 1];
  if (word < LABMOUSE_DRIVE || word > LABMOUSE_FORFEIT) word = LABMOUSE_FORFEIT;
  fputs(words[word], stdout);
  for (i = 0; i < count && word < LABMOUSE_CARRY; ++i) printf(" %d %d", (int)said[i].left, (int)said[i].right);
  putchar('\n');
  fflush(stdout);
}

/** Runs one contest over standard input and output: docs/reference/protocols.md has the lines.
 * @param argc number of arguments, the program's name among them.
 * @param argv the first argument, if there is one, replaces the batch of labmouse_controller.
 * @return 0 at the end of the input. */
int main(int argc, char** argv) {
  static struct labmouse_briefing told;
  const int batch = argc > 1 ? atoi(argv[1]) : labmouse_controller.batch;
  int begun = 0;
  void* memory = NULL;
  char* line;
  while ((line = labmouse_read_line()) != NULL) {
    if (strncmp(line, "sense ", 6) == 0) {
      labmouse_answer(&told.robot, memory, line + 5, batch);
    } else if (strncmp(line, "carried ", 8) == 0) {
      labmouse_controller.carried(memory, strcmp(line + 8, "crash") == 0);
    } else if (strcmp(line, "begin") == 0) {
      memory = labmouse_controller.begin(&told);
      begun = 1;
      puts("labmouse pilot 1");
      fflush(stdout);
    } else {
      labmouse_be_told(line, &told);
    }
  }
  if (begun) labmouse_controller.end(memory);
  return 0;
}

#endif
/* NOLINTEND */
#endif
