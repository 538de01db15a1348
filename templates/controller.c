/* A controller for labmouse: the whole program of a mouse, from sensor readings to motor duties.
 *
 * It floods to the goal, drives home, and then makes speed runs, faster over known cells. It stops to turn.
 * Side walls correct its lateral position; the ends of side walls, and walls ahead, correct its longitudinal position.
 * To race it: cc -std=c99 -O2 -DLABMOUSE_CONTROLLER_MAIN controller.c -o controller -lm */
#include "labmouse_controller.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 64 }; /* cells of a maze at most */
enum phase { SEARCH, HOME, RUN };
enum work { REST, PIVOT, STRAIGHT };
static const double TICK = 0.001, PI = 3.14159265358979;
static const int EAST[] = {0, 1, 0, -1}, NORTH[] = {1, 0, -1, 0}; /* by headings 0 to 3 */

struct controller {
  const struct labmouse_briefing *told;
  double cell, search_speed, fast_speed, rate; /* mm, mm/s, mm/s² */
  double spot, fall; /* mm: point ahead of the axle that side beams meet; lateral distance for 1/e of a reading */
  int8_t walls[SIDE][SIDE][4], seen[SIDE][SIDE]; /* walls: 1 open, -1 closed, 0 unknown; cells that were read */
  enum phase phase;
  enum work work;
  int rest, x, y, heading; /* ms left to rest; the cell that it enters or stands in */
  double east, north, angle, speed, turning; /* estimate: mm, rad left of east, mm/s, rad/s */
  double wanted_speed, wanted_turning, volts, levels[2];
  int32_t counts;
  int counted, beside[2], range; /* whether there is a wall left and right; -1: not read */
  enum labmouse_word word;
};

static double limited(double number, double most) { return number > most ? most : number < -most ? -most : number; }

/* Position along its heading, and lateral offset to the left of the middle of its row or column. */
static double middle(int index, const struct controller *p) { return (index + 0.5) * p->cell; }
static double along(const struct controller *p) { return p->east * EAST[p->heading] + p->north * NORTH[p->heading]; }
static double left_of_way(const struct controller *p) { /* distance to the middle of the cell that it enters, mm */
  return middle(p->x, p) * EAST[p->heading] + middle(p->y, p) * NORTH[p->heading] - along(p);
}
static double aside(const struct controller *p) {
  return (p->north - middle(p->y, p)) * EAST[p->heading] - (p->east - middle(p->x, p)) * NORTH[p->heading];
}
static double off_heading(const struct controller *p) {
  return remainder(p->angle - PI / 2 * (1 - p->heading), 2 * PI);
}
static void shift(struct controller *p, double ahead, double left) {
  p->east += ahead * EAST[p->heading] - left * NORTH[p->heading];
  p->north += ahead * NORTH[p->heading] + left * EAST[p->heading];
}

/* Estimation from the sensors. */
static int is_wall(const struct controller *p, int side) {
  return p->levels[side] > 0.3 * p->told->robot.sensors_infrared_gain;
}

static void keep_to_walls(struct controller *p, int range_new) {
  const double place = (along(p) + p->spot) / p->cell, line = floor(place + 0.5); /* of side beams' spots, in cells */
  const double face = (along(p) + p->told->robot.sensors_ranger_ahead + p->range) / p->cell + 1 / 30.0;
  const double missing = (floor(face + 0.5) - face) * p->cell;
  for (int side = 0; side < 2; ++side) {
    const int before = p->beside[side], now = is_wall(p, side);
    if (now && fabs(place - line) > 0.25) {
      const double level = p->levels[side] / p->told->robot.sensors_infrared_gain;
      const double off = (side == 0 ? p->fall : -p->fall) * log(level) - aside(p);
      shift(p, 0, 0.02 * off);
      p->angle += 0.005 * off / p->cell;
    } else if (before >= 0 && before != now) { /* walls end half a post behind a line, or begin as much before */
      shift(p, 0.3 * (line + (before ? 1 : -1) / 30.0 - place) * p->cell, 0);
    }
    p->beside[side] = now;
  }
  if (range_new && p->range > 0 && p->range < 1.2 * p->cell && fabs(missing) < 0.2 * p->cell)
    shift(p, 0.1 * missing, 0);
}

static void read_sense(struct controller *p, const struct labmouse_sense *sense) {
  const struct labmouse_robot *robot = &p->told->robot;
  const int32_t counts = sense->counts[0] + sense->counts[1];
  const double way = p->counted ? (counts - p->counts) / 2.0 * robot->sensors_count : 0;
  p->counts = counts;
  p->counted = 1;
  p->turning = sense->gyro * robot->sensors_gyro_step;
  p->speed += 0.1 * (way / TICK - p->speed);
  p->east += way * cos(p->angle);
  p->north += way * sin(p->angle);
  p->angle += p->turning * TICK;
  p->levels[0] += 0.3 * (fmax(sense->infrared[2], 1) - p->levels[0]);
  p->levels[1] += 0.3 * (fmax(sense->infrared[0], 1) - p->levels[1]);
  p->range = sense->ranges[0];
  p->volts = sense->millivolts / 1000.0;
  if (fabs(off_heading(p)) < 0.2 && p->speed > 0.3 * p->search_speed) keep_to_walls(p, sense->ranges_new[0]);
}

/* Records the walls of its cell. */
static void look(struct controller *p) {
  const double to_wall = left_of_way(p) + p->cell / 2 - p->told->robot.sensors_ranger_ahead;
  const int walls[] = {is_wall(p, 0), p->range > 0 && p->range < to_wall + 0.4 * p->cell, is_wall(p, 1)};
  for (int turn = -1; turn <= 1; ++turn) {
    const int way = (p->heading + turn) & 3, x = p->x + EAST[way], y = p->y + NORTH[way];
    if (p->walls[p->x][p->y][way] == 0) p->walls[p->x][p->y][way] = walls[turn + 1] ? -1 : 1;
    if (x >= 0 && y >= 0 && x < p->told->width && y < p->told->height)
      p->walls[x][y][(way + 2) & 3] = p->walls[p->x][p->y][way];
  }
  p->seen[p->x][p->y] = 1;
}

/* Route planning. */
static int is_target(const struct controller *p, int x, int y) {
  if (p->phase == HOME) return x == p->told->start.x && y == p->told->start.y;
  for (int i = 0; i < p->told->goals; ++i)
    if (p->told->goal[i].x == x && p->told->goal[i].y == y) return 1;
  return 0;
}

static int leads(const struct controller *p, int x, int y, int way) {
  const int to_x = x + EAST[way], to_y = y + NORTH[way];
  if (to_x < 0 || to_y < 0 || to_x >= p->told->width || to_y >= p->told->height) return 0;
  return p->phase == RUN ? p->walls[x][y][way] > 0 : p->walls[x][y][way] >= 0;
}

/* Direction of the first step of a shortest way; prefers straight on. */
static int way_to_target(struct controller *p) {
  int left[SIDE][SIDE], queue[SIDE * SIDE], size = 0;
  for (int x = 0; x < p->told->width; ++x)
    for (int y = 0; y < p->told->height; ++y) {
      left[x][y] = is_target(p, x, y) ? 0 : -1;
      if (left[x][y] == 0) queue[size++] = x * SIDE + y;
    }
  for (int i = 0; i < size; ++i)
    for (int way = 0; way < 4; ++way) {
      const int x = queue[i] / SIDE, y = queue[i] % SIDE, to_x = x + EAST[way], to_y = y + NORTH[way];
      if (!leads(p, x, y, way) || left[to_x][to_y] >= 0) continue;
      left[to_x][to_y] = left[x][y] + 1;
      queue[size++] = to_x * SIDE + to_y;
    }
  for (int i = 0; i < 4; ++i) {
    static const int turns[] = {0, 1, 3, 2};
    const int way = (p->heading + turns[i]) & 3;
    if (left[p->x][p->y] > 0 && leads(p, p->x, p->y, way) &&
        left[p->x + EAST[way]][p->y + NORTH[way]] == left[p->x][p->y] - 1)
      return way;
  }
  memset(p->walls, 0, sizeof p->walls); /* no route left: it clears its map */
  memset(p->seen, 0, sizeof p->seen);
  if (p->phase == RUN) p->phase = SEARCH;
  return way_to_target(p);
}

/* Plans straight on through known cells, and one unknown cell. */
static void plan_on(struct controller *p) {
  while (!is_target(p, p->x, p->y) && way_to_target(p) == p->heading) {
    p->x += EAST[p->heading];
    p->y += NORTH[p->heading];
    if (!p->seen[p->x][p->y]) return;
  }
}

static void begin_rest(struct controller *p, int ms) {
  p->work = REST;
  p->rest = ms;
  p->wanted_speed = 0;
}

static void begin_pivot(struct controller *p, int heading) {
  p->work = PIVOT;
  p->heading = heading;
  p->beside[0] = p->beside[1] = -1;
  p->wanted_turning = 0;
}

/* Chooses the next action at rest. */
static void begin_next(struct controller *p) {
  if (!p->seen[p->x][p->y]) look(p);
  if (is_target(p, p->x, p->y) && p->phase == HOME) {
    if (p->heading != (int)p->told->start_heading) {
      begin_pivot(p, (int)p->told->start_heading);
      return;
    }
    p->phase = RUN;
    p->word = LABMOUSE_FAST;
  } else if (is_target(p, p->x, p->y)) {
    p->phase = HOME;
    p->word = LABMOUSE_GOAL;
  }
  const int way = way_to_target(p);
  if (way != p->heading) {
    begin_pivot(p, way);
  } else {
    p->work = STRAIGHT;
    plan_on(p);
  }
}

/* Motion control: returns the turn rate in rad/s; sets wanted_speed. */
static double drive_straight(struct controller *p) {
  const double bend = 2.5 / p->cell; /* how fast the lateral error decays, 1/mm */
  if (!p->seen[p->x][p->y] &&
      left_of_way(p) < p->wanted_speed * p->wanted_speed / 2 / p->rate + 0.06 * p->cell) {
    look(p);
    plan_on(p);
  }
  const double most = p->phase == RUN && p->seen[p->x][p->y] ? p->fast_speed : p->search_speed;
  /* A run ends just past the middle of a goal. */
  const double past = p->phase != HOME && is_target(p, p->x, p->y) ? 0.05 * p->cell : 0;
  const double left = left_of_way(p) + past, stop = sqrt(2 * p->rate * fmax(left + 0.002 * p->cell, 0));
  p->wanted_speed = fmin(fmin(p->wanted_speed + p->rate * TICK, most), stop);
  if (left < 0.005 * p->cell) begin_rest(p, 50);
  return -fmax(p->wanted_speed, p->cell) * bend * (bend * aside(p) + 1.6 * off_heading(p));
}

static double drive_pivot(struct controller *p) {
  const double off = -off_heading(p), most = 9, rate = 90; /* rad/s, rad/s² */
  if (fabs(off) < 0.02 && fabs(p->turning) < 0.3) begin_rest(p, 50);
  if (fabs(off) < 0.02) return 8 * off;
  return copysign(fmin(fmin(fabs(p->wanted_turning) + rate * TICK, most), sqrt(1.4 * rate * fabs(off))), off);
}

/* Duty: feedforward by the nominal motor model, plus a proportional term for the error. */
static double duty(double gain, double time, double dead_zone, double wanted, double rate, double now) {
  return (wanted + time / 1000 * (rate + 25 * (wanted - now))) / gain + dead_zone * limited(200 * wanted / gain, 1);
}

static struct labmouse_drive tick(void *memory, const struct labmouse_sense *sense) {
  struct controller *p = (struct controller *)memory;
  const struct labmouse_robot *robot = &p->told->robot;
  read_sense(p, sense);
  if (p->work == REST && --p->rest < 0) begin_next(p);
  const double speed = p->wanted_speed;
  const double turning =
      p->work == STRAIGHT ? drive_straight(p) : p->work == PIVOT ? drive_pivot(p) : -8 * off_heading(p);
  const double twist = limited((turning - p->wanted_turning) / TICK, 80);
  p->wanted_turning = turning;
  const double drive = duty(robot->motors_drive_gain, robot->motors_drive_time, robot->motors_drive_dead_zone,
                            p->wanted_speed, limited((p->wanted_speed - speed) / TICK, p->rate), p->speed);
  const double turn = duty(robot->motors_turn_gain, robot->motors_turn_time, robot->motors_turn_dead_zone, turning,
                           twist, p->turning);
  const double most = LABMOUSE_FULL, full = most * robot->motors_volts / p->volts;
  const struct labmouse_drive said = {(int32_t)limited(full * (drive - turn / 2), most),
                                      (int32_t)limited(full * (drive + turn / 2), most), p->word};
  p->word = LABMOUSE_DRIVE;
  return said;
}

static void put_at_start(void *memory, int crashed) {
  struct controller *p = (struct controller *)memory;
  (void)crashed;
  p->x = p->told->start.x;
  p->y = p->told->start.y;
  p->heading = (int)p->told->start_heading;
  p->east = middle(p->x, p);
  p->north = middle(p->y, p);
  p->angle = PI / 2 * (1 - p->heading);
  p->speed = p->turning = p->wanted_turning = 0;
  p->beside[0] = p->beside[1] = -1;
  p->phase = SEARCH;
  for (int i = 0; i < p->told->goals; ++i)
    if (p->seen[p->told->goal[i].x][p->told->goal[i].y]) p->phase = RUN;
  p->word = p->phase == RUN ? LABMOUSE_FAST : LABMOUSE_DRIVE;
  begin_rest(p, 100);
}

static void *begin(const struct labmouse_briefing *told) {
  const struct labmouse_robot *robot = &told->robot;
  if (robot->infrared_sensors != 4 || robot->sensors_side_angle == 0 || robot->range_sensors != 1 ||
      robot->sensors_ranger_reach == 0 || robot->sensors_gyro_step == 0) {
    fputs("controller.c needs a robot with pairs of side and front sensors, a ToF sensor and a gyro, such as kerise\n",
          stderr);
    exit(1);
  }
  struct controller *p = (struct controller *)calloc(1, sizeof *p);
  const double face = told->cell / 2 - told->cell / 30, angle = told->robot.sensors_side_angle;
  if (p == NULL) exit(1);
  p->told = told;
  p->cell = told->cell;
  p->search_speed = 3 * p->cell;
  p->fast_speed = 6 * p->cell;
  p->rate = fmin(40 * p->cell, 0.4 * told->robot.body_grip);
  p->spot = told->robot.sensors_side_ahead + (face - told->robot.sensors_side_aside) / tan(angle);
  p->fall = told->robot.sensors_infrared_fall * sin(angle);
  put_at_start(p, 0);
  return p;
}

const struct labmouse_controller labmouse_controller = {begin, tick, put_at_start, free, 4};
