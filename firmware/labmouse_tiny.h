/* Flood fill for small chips, such as the ATmega328 of an Arduino Uno: a search run and a speed run in 16x16 cells.
 * C99 and C++11. It needs no other code and takes no memory but a struct labmouse_tiny of the caller.
 *
 *   struct labmouse_tiny mouse;
 *   enum labmouse_tiny_move move;
 *   labmouse_tiny_create(&mouse, 1);
 *   do {
 *     labmouse_tiny_observe(&mouse, wall_left(), wall_ahead(), wall_right());
 *     if (labmouse_tiny_decide(&mouse, &move) != LABMOUSE_TINY_OK) stop();
 *     drive(move);
 *   } while (move != LABMOUSE_TINY_END);
 *   labmouse_tiny_start(&mouse, 1);   the speed run, with the mouse at the start again
 *
 * Both runs are those of labmouse's strategies `flood` and `flood-return` in steps of one cell, with sensors that see
 * the walls of one cell. Each function returns a status. If it is not LABMOUSE_TINY_OK, nothing has
 * changed. Cells count from (0,0) in the south-west corner, where the mouse starts, heading north.
 */
#ifndef LABMOUSE_TINY_H
#define LABMOUSE_TINY_H
#include <stdint.h>

#define LABMOUSE_TINY_VERSION 1 /* of the saved map */
#define LABMOUSE_TINY_SIDE 16   /* cells */
#define LABMOUSE_TINY_SAVED 166 /* bytes of a saved map */

enum labmouse_tiny_status {
  LABMOUSE_TINY_OK,
  LABMOUSE_TINY_NULL,          /* a pointer is null */
  LABMOUSE_TINY_ORDER,         /* the function is not allowed now */
  LABMOUSE_TINY_RANGE,         /* an argument is out of range */
  LABMOUSE_TINY_CONTRADICTION, /* a reading contradicts the map; observe again, or create the mouse anew */
  LABMOUSE_TINY_NO_ROUTE,      /* the map has no route to where the mouse is to go */
  LABMOUSE_TINY_BAD_MAP        /* there is no saved map, it has another version, or it is corrupted */
};

enum labmouse_tiny_move {
  LABMOUSE_TINY_AHEAD, /* one cell ahead */
  LABMOUSE_TINY_RIGHT, /* a quarter turn to the right, then one cell ahead */
  LABMOUSE_TINY_BACK,  /* one cell backwards, without a turn; see labmouse_tiny_turned */
  LABMOUSE_TINY_LEFT,  /* a quarter turn to the left, then one cell ahead */
  LABMOUSE_TINY_LOOK,  /* a quarter turn to the right only, to see another wall */
  LABMOUSE_TINY_END    /* no move: the run has ended */
};

/* The sets of a mouse. A wall is the one east or north of its cell. */
enum {
  labmouse_tiny_open,         /* walls to the east that are known to be open; those to the north are the next set */
  labmouse_tiny_possible = 2, /* walls to the east that are not known to be closed; those to the north are the next */
  labmouse_tiny_goals = 4,
  labmouse_tiny_sets
};

/* The fields may be read, but only the functions change them. */
struct labmouse_tiny {
  uint16_t sets[labmouse_tiny_sets][LABMOUSE_TINY_SIDE]; /* bit x of row y is cell (x,y) */
  uint8_t x, y;
  uint8_t heading; /* 0 north, 1 east, 2 south, 3 west */
  uint8_t next;    /* which function is allowed next */
  uint8_t run;     /* which run this is */
  uint8_t returns; /* whether the search run ends at the start */
};

/* Values of `next` and `run`. They are unlikely in memory that was never set. */
enum { labmouse_tiny_first = 0xA5, labmouse_tiny_seen, labmouse_tiny_moved, labmouse_tiny_ended };
enum { labmouse_tiny_to_goal, labmouse_tiny_to_start, labmouse_tiny_speed };

static inline uint8_t labmouse_tiny_is_made(const struct labmouse_tiny *mouse) {
  return mouse->next >= labmouse_tiny_first && mouse->next <= labmouse_tiny_ended;
}

static inline uint8_t labmouse_tiny_in_goal(const struct labmouse_tiny *mouse) {
  return (uint8_t)(mouse->sets[labmouse_tiny_goals][mouse->y] >> mouse->x & 1u);
}

/* Puts the mouse at the start, where a run begins. Its map stays as it is.
 * speed: 0 for a search run, 1 for a speed run, which takes the shortest known route. */
static inline enum labmouse_tiny_status labmouse_tiny_start(struct labmouse_tiny *mouse, uint8_t speed) {
  if (!mouse) return LABMOUSE_TINY_NULL;
  if (!labmouse_tiny_is_made(mouse)) return LABMOUSE_TINY_ORDER;
  if (speed > 1) return LABMOUSE_TINY_RANGE;
  mouse->x = mouse->y = mouse->heading = 0;
  mouse->next = labmouse_tiny_first;
  mouse->run = speed ? labmouse_tiny_speed : labmouse_tiny_to_goal;
  return LABMOUSE_TINY_OK;
}

/* Begins with an empty map, the four cells in the middle as the goal, and a search run. To be called first.
 * returns: 1 if the search run ends at the start, as `flood-return`; 0 if it ends in the goal, as `flood`. */
static inline enum labmouse_tiny_status labmouse_tiny_create(struct labmouse_tiny *mouse, uint8_t returns) {
  uint8_t y;
  if (!mouse) return LABMOUSE_TINY_NULL;
  if (returns > 1) return LABMOUSE_TINY_RANGE;
  for (y = 0; y < LABMOUSE_TINY_SIDE; ++y) {
    mouse->sets[labmouse_tiny_open][y] = mouse->sets[labmouse_tiny_open + 1][y] = 0;
    mouse->sets[labmouse_tiny_possible][y] = 0x7FFF;
    mouse->sets[labmouse_tiny_possible + 1][y] = y + 1 < LABMOUSE_TINY_SIDE ? 0xFFFF : 0;
    mouse->sets[labmouse_tiny_goals][y] = y == 7 || y == 8 ? 0x0180 : 0;
  }
  mouse->next = labmouse_tiny_first;
  mouse->returns = returns;
  return labmouse_tiny_start(mouse, 0);
}

/* Sets the goal. Allowed before the first reading of a run.
 * cells: x and y of each cell.
 * count: how many cells, at least 1. */
static inline enum labmouse_tiny_status labmouse_tiny_set_goals(struct labmouse_tiny *mouse, const uint8_t (*cells)[2],
                                                                uint8_t count) {
  uint8_t i;
  if (!mouse || !cells) return LABMOUSE_TINY_NULL;
  if (mouse->next != labmouse_tiny_first) return LABMOUSE_TINY_ORDER;
  if (count == 0) return LABMOUSE_TINY_RANGE;
  for (i = 0; i < count; ++i)
    if (cells[i][0] >= LABMOUSE_TINY_SIDE || cells[i][1] >= LABMOUSE_TINY_SIDE) return LABMOUSE_TINY_RANGE;
  for (i = 0; i < LABMOUSE_TINY_SIDE; ++i) mouse->sets[labmouse_tiny_goals][i] = 0;
  for (i = 0; i < count; ++i) mouse->sets[labmouse_tiny_goals][cells[i][1]] |= (uint16_t)(1u << cells[i][0]);
  return LABMOUSE_TINY_OK;
}

/* Where the wall on one side of the present cell is stored: in the set of walls to the east (0) or north (1), in which
 * row and at which bit. A bit of 0 is the border in the south or west, which is not stored. */
struct labmouse_tiny_wall {
  uint8_t north, row;
  uint16_t bit;
};
static inline struct labmouse_tiny_wall labmouse_tiny_wall_at(const struct labmouse_tiny *mouse, uint8_t side) {
  struct labmouse_tiny_wall wall;
  wall.north = side & 1u ? 0 : 1;
  wall.row = mouse->y;
  wall.bit = (uint16_t)(1u << mouse->x);
  if (side == 3) wall.bit >>= 1;
  if (side == 2 && wall.row-- == 0) wall.row = 0, wall.bit = 0;
  return wall;
}

/* Learns the walls of the present cell: each 1 if there is a wall, 0 if not. Allowed at the start of a run and after
 * each move. */
static inline enum labmouse_tiny_status labmouse_tiny_observe(struct labmouse_tiny *mouse, uint8_t left, uint8_t ahead,
                                                              uint8_t right) {
  uint8_t learn, i;
  if (!mouse) return LABMOUSE_TINY_NULL;
  if (mouse->next != labmouse_tiny_first && mouse->next != labmouse_tiny_moved) return LABMOUSE_TINY_ORDER;
  if (left > 1 || ahead > 1 || right > 1) return LABMOUSE_TINY_RANGE;
  for (learn = 0; learn < 2; ++learn)
    for (i = 0; i < 3; ++i) {
      const struct labmouse_tiny_wall wall = labmouse_tiny_wall_at(mouse, (uint8_t)(mouse->heading + 3 + i) & 3u);
      const uint8_t closed = i == 0 ? left : i == 1 ? ahead : right;
      uint16_t *const open = &mouse->sets[labmouse_tiny_open + wall.north][wall.row];
      uint16_t *const possible = &mouse->sets[labmouse_tiny_possible + wall.north][wall.row];
      if (closed ? (*open & wall.bit) != 0 : (*possible & wall.bit) == 0) return LABMOUSE_TINY_CONTRADICTION;
      if (learn && closed)
        *possible &= (uint16_t)~wall.bit;
      else if (learn)
        *open |= wall.bit;
    }
  mouse->next = labmouse_tiny_seen;
  return LABMOUSE_TINY_OK;
}

/* The first side, counted from the heading in the order ahead, left, right, back, on which a shortest route leads from
 * the mouse to the cells `layer`; 4 if none does. A breadth-first search from these cells, in which all cells of a row
 * advance at once. It needs no distances: it ends with the layer in which the mouse is. The mouse is in none of `layer`.
 * passages: the walls that can be passed, labmouse_tiny_open or labmouse_tiny_possible.
 * layer: is overwritten. */
static inline uint8_t labmouse_tiny_flood(const struct labmouse_tiny *mouse, uint8_t passages, uint16_t *layer) {
  const uint16_t *const east = mouse->sets[passages], *const north = mouse->sets[passages + 1];
  const uint16_t bit = (uint16_t)(1u << mouse->x);
  uint16_t reached[LABMOUSE_TINY_SIDE];
  uint8_t i, y, lowest = 0, highest = LABMOUSE_TINY_SIDE - 1;
  for (y = 0; y < LABMOUSE_TINY_SIDE; ++y) reached[y] = layer[y];
  do {
    /* The next layer replaces the last one, row by row; `lowest` to `highest` are the rows that it can have. */
    uint16_t below = 0, here = layer[lowest];
    uint8_t begin = LABMOUSE_TINY_SIDE, end = 0;
    for (y = lowest; y <= highest; ++y) {
      const uint16_t above = y + 1 < LABMOUSE_TINY_SIDE ? layer[y + 1] : 0;
      uint16_t next = 0;
      if (here) next = (uint16_t)((here & east[y]) << 1) | (uint16_t)(here >> 1 & east[y]);
      if (above) next |= above & north[y];
      if (below) next |= below & north[y - 1];
      if (next) next &= (uint16_t)~reached[y];
      layer[y] = next;
      below = here;
      here = above;
      if (!next) continue;
      reached[y] |= next;
      if (begin == LABMOUSE_TINY_SIDE) begin = y;
      end = y;
    }
    if (begin == LABMOUSE_TINY_SIDE) return 4;
    lowest = (uint8_t)(begin - (begin > 0));
    highest = (uint8_t)(end + (end + 1 < LABMOUSE_TINY_SIDE));
  } while (!(layer[mouse->y] & bit));
  /* The mouse was reached last, so its neighbours in earlier layers are all in the one before. */
  for (i = 0; i < 3; ++i) {
    const uint8_t turn = i == 0 ? 0 : i == 1 ? 3 : 1, side = (uint8_t)(mouse->heading + turn) & 3u;
    const struct labmouse_tiny_wall wall = labmouse_tiny_wall_at(mouse, side);
    uint16_t next = (wall.north ? north : east)[wall.row] & wall.bit;
    y = (uint8_t)(wall.row + (side == 0 && next));
    if (side == 1) next = (uint16_t)(next << 1);
    if (reached[y] & ~layer[y] & next) return turn;
  }
  return 2;
}

/* Decides on the next move, which the mouse is taken to have made when the next reading comes. Allowed after
 * labmouse_tiny_observe. After a status of LABMOUSE_TINY_NO_ROUTE, start another run or create the mouse anew. */
static inline enum labmouse_tiny_status labmouse_tiny_decide(struct labmouse_tiny *mouse,
                                                             enum labmouse_tiny_move *move) {
  uint16_t to[LABMOUSE_TINY_SIDE];
  uint8_t run, turn, side, y;
  struct labmouse_tiny_wall wall;
  if (!mouse || !move) return LABMOUSE_TINY_NULL;
  if (mouse->next != labmouse_tiny_seen) return LABMOUSE_TINY_ORDER;
  run = mouse->run;
  if (run == labmouse_tiny_to_goal && mouse->returns && labmouse_tiny_in_goal(mouse)) run = labmouse_tiny_to_start;
  if (run == labmouse_tiny_to_start ? mouse->x == 0 && mouse->y == 0 : labmouse_tiny_in_goal(mouse)) {
    *move = LABMOUSE_TINY_END;
    mouse->next = labmouse_tiny_ended;
    return LABMOUSE_TINY_OK;
  }
  for (y = 0; y < LABMOUSE_TINY_SIDE; ++y) to[y] = run == labmouse_tiny_to_start ? y == 0 : mouse->sets[labmouse_tiny_goals][y];
  turn = labmouse_tiny_flood(mouse, run == labmouse_tiny_speed ? labmouse_tiny_open : labmouse_tiny_possible, to);
  if (turn == 4) return LABMOUSE_TINY_NO_ROUTE;
  side = (uint8_t)(mouse->heading + turn) & 3u;
  wall = labmouse_tiny_wall_at(mouse, side);
  mouse->run = run;
  mouse->next = labmouse_tiny_moved;
  if (!(mouse->sets[labmouse_tiny_open + wall.north][wall.row] & wall.bit)) { /* only the wall behind can be unknown */
    mouse->heading = (uint8_t)(mouse->heading + 1) & 3u;
    *move = LABMOUSE_TINY_LOOK;
    return LABMOUSE_TINY_OK;
  }
  if (side == 0) ++mouse->y;
  if (side == 1) ++mouse->x;
  if (side == 2) --mouse->y;
  if (side == 3) --mouse->x;
  if (turn != 2) mouse->heading = side;
  *move = (enum labmouse_tiny_move)turn;
  return LABMOUSE_TINY_OK;
}

/* Says that the mouse has turned by itself, for example half round in place of driving backwards. Allowed where
 * labmouse_tiny_observe is.
 * quarters: quarter turns to the right, 0 to 3. */
static inline enum labmouse_tiny_status labmouse_tiny_turned(struct labmouse_tiny *mouse, uint8_t quarters) {
  if (!mouse) return LABMOUSE_TINY_NULL;
  if (mouse->next != labmouse_tiny_first && mouse->next != labmouse_tiny_moved) return LABMOUSE_TINY_ORDER;
  if (quarters > 3) return LABMOUSE_TINY_RANGE;
  mouse->heading = (uint8_t)(mouse->heading + quarters) & 3u;
  return LABMOUSE_TINY_OK;
}

/* Prints the map as `labmouse show` reads it: 33 lines of 66 characters.
 * put: prints one character, such as putchar(); its result is not used. */
static inline enum labmouse_tiny_status labmouse_tiny_print(const struct labmouse_tiny *mouse, int (*put)(int letter)) {
  uint8_t line, x, i;
  if (!mouse || !put) return LABMOUSE_TINY_NULL;
  if (!labmouse_tiny_is_made(mouse)) return LABMOUSE_TINY_ORDER;
  /* Lines of walls and of cells in turn, from the north. A wall north of row y is south of row y + 1. */
  for (line = 2 * LABMOUSE_TINY_SIDE + 1; line-- > 0;) {
    const uint8_t cells = line & 1u, y = line / 2;
    for (x = 0; x <= LABMOUSE_TINY_SIDE; ++x) {
      uint8_t open = 0, possible = 0;
      char wall, letter = ' ';
      if (cells ? x > 0 : y > 0 && x < LABMOUSE_TINY_SIDE) {
        const uint8_t north = cells ? 0 : 1, row = cells ? y : (uint8_t)(y - 1), bit = cells ? (uint8_t)(x - 1) : x;
        open = (uint8_t)(mouse->sets[labmouse_tiny_open + north][row] >> bit & 1u);
        possible = (uint8_t)(mouse->sets[labmouse_tiny_possible + north][row] >> bit & 1u);
      }
      wall = open ? ' ' : possible ? (cells ? ':' : '.') : cells ? '|' : '-';
      put(cells ? wall : 'o');
      if (x == LABMOUSE_TINY_SIDE) break;
      if (cells && y == 0 && x == 0) letter = 'S';
      if (cells && mouse->sets[labmouse_tiny_goals][y] >> x & 1u) letter = 'G';
      for (i = 0; i < 3; ++i) put(cells ? (i == 1 ? letter : ' ') : wall);
    }
    put('\n');
  }
  return LABMOUSE_TINY_OK;
}

/* Of a saved map: "LM", the version, the side, the rows of all sets with the low byte first, and the
 * checksum of all of these, CRC-16 with the polynomial 0x1021 from 0xFFFF, high byte first. */
static inline uint16_t labmouse_tiny_checksum(uint16_t sum, uint8_t byte) {
  uint8_t i;
  sum ^= (uint16_t)((uint16_t)byte << 8);
  for (i = 0; i < 8; ++i) sum = sum & 0x8000u ? (uint16_t)((uint16_t)(sum << 1) ^ 0x1021u) : (uint16_t)(sum << 1);
  return sum;
}
static inline uint8_t labmouse_tiny_header(uint8_t at) {
  return at == 0 ? 'L' : at == 1 ? 'M' : at == 2 ? LABMOUSE_TINY_VERSION : LABMOUSE_TINY_SIDE;
}

/* Saves the map and the goal, for example to EEPROM.
 * write: stores a byte at an address from 0 to LABMOUSE_TINY_SAVED - 1. */
static inline enum labmouse_tiny_status labmouse_tiny_save(const struct labmouse_tiny *mouse,
                                                           void (*write)(uint16_t address, uint8_t byte)) {
  uint16_t sum = 0xFFFF;
  uint8_t at;
  if (!mouse || !write) return LABMOUSE_TINY_NULL;
  if (!labmouse_tiny_is_made(mouse)) return LABMOUSE_TINY_ORDER;
  for (at = 0; at < LABMOUSE_TINY_SAVED - 2; ++at) {
    const uint8_t row = (uint8_t)(at - 4) / 2;
    const uint8_t byte =
        at < 4 ? labmouse_tiny_header(at)
               : (uint8_t)(mouse->sets[row / LABMOUSE_TINY_SIDE][row % LABMOUSE_TINY_SIDE] >> (at & 1u ? 8 : 0));
    sum = labmouse_tiny_checksum(sum, byte);
    write(at, byte);
  }
  write(at, (uint8_t)(sum >> 8));
  write((uint16_t)(at + 1), (uint8_t)sum);
  return LABMOUSE_TINY_OK;
}

static inline uint16_t labmouse_tiny_saved_row(uint8_t (*read)(uint16_t address), uint8_t set, uint8_t y) {
  const uint16_t at = (uint16_t)(4 + 2 * (set * LABMOUSE_TINY_SIDE + y)), low = read(at);
  const uint16_t high = read((uint16_t)(at + 1));
  return (uint16_t)(low | high << 8);
}

/* Restores a saved map and its goal. Allowed before the first reading of a run; the run stays the same.
 * read: the byte at an address from 0 to LABMOUSE_TINY_SAVED - 1. */
static inline enum labmouse_tiny_status labmouse_tiny_restore(struct labmouse_tiny *mouse,
                                                              uint8_t (*read)(uint16_t address)) {
  uint16_t sum = 0xFFFF, any_goal = 0;
  uint8_t at, set, y;
  if (!mouse || !read) return LABMOUSE_TINY_NULL;
  if (mouse->next != labmouse_tiny_first) return LABMOUSE_TINY_ORDER;
  for (at = 0; at < LABMOUSE_TINY_SAVED; ++at) {
    const uint8_t byte = read(at);
    if (at < 4 && byte != labmouse_tiny_header(at)) return LABMOUSE_TINY_BAD_MAP;
    sum = labmouse_tiny_checksum(sum, byte);
  }
  if (sum != 0) return LABMOUSE_TINY_BAD_MAP; /* so it is after its own checksum */
  for (y = 0; y < LABMOUSE_TINY_SIDE; ++y) {
    any_goal |= labmouse_tiny_saved_row(read, labmouse_tiny_goals, y);
    for (set = 0; set < 2; ++set) {
      const uint16_t inner = set == 0 ? 0x7FFF : y + 1 < LABMOUSE_TINY_SIDE ? 0xFFFF : 0;
      const uint16_t possible = labmouse_tiny_saved_row(read, (uint8_t)(labmouse_tiny_possible + set), y);
      if ((possible & ~inner) || (labmouse_tiny_saved_row(read, set, y) & ~possible)) return LABMOUSE_TINY_BAD_MAP;
    }
  }
  if (!any_goal) return LABMOUSE_TINY_BAD_MAP;
  for (set = 0; set < labmouse_tiny_sets; ++set)
    for (y = 0; y < LABMOUSE_TINY_SIDE; ++y) mouse->sets[set][y] = labmouse_tiny_saved_row(read, set, y);
  return LABMOUSE_TINY_OK;
}
#endif
