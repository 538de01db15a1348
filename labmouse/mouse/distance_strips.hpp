// The search behind DistanceField for sets of many vectors, compiled once for each width of vector; see
// distance_rows.hpp.
#pragma once

#include "labmouse/mouse/distance_rows.hpp"

namespace labmouse {

namespace LABMOUSE_KERNEL {
namespace {

/// One chunk of all sets that a layer of a large maze needs, side by side: one address for all of them.
template <class Word>
struct Strip {
  using Chunk = typename Rows<Word>::Chunk;

  Chunk last;  ///< the cells of the last layer
  Chunk unreached;
  /// Cells that can be entered by a straight move of one cell and, for longer moves, of two.
  Chunk north[2], south[2], east[2], west[2];
};

/// The strips of a large maze, southernmost first, with empty ones round them, so that each has neighbours.
template <class Word>
struct Strips {
  static constexpr int chunks = Rows<Word>::chunks;
  Strip<Word> strip[chunks + 3];

  [[gnu::always_inline]] Strip<Word>& at(int chunk) { return strip[chunk + 1]; }
};

/// Rows of two neighbouring chunks, moved K rows: those that come into the northern one, or into the southern one.
template <int K, class Word, class Chunk>
[[gnu::always_inline]] inline Chunk into_north(Chunk south, Chunk north) {
  if constexpr (K == Rows<Word>::lanes) return south;
  return window<Rows<Word>::lanes - K>(south, north, typename CountLanes<Rows<Word>::lanes>::type{});
}
template <int K, class Word, class Chunk>
[[gnu::always_inline]] inline Chunk into_south(Chunk south, Chunk north) {
  if constexpr (K == Rows<Word>::lanes) return north;
  return window<K>(south, north, typename CountLanes<Rows<Word>::lanes>::type{});
}

template <int Longest, class Word>
[[gnu::always_inline]] inline void lay_out(const FieldOrder& order, Strips<Word>& strips) {
  constexpr int kept = Longest > 1 ? 2 : 1;
  Entries<Word, kept> enter;
  find_entries<kept>(order, enter);
  Rows<Word> from;
  narrow(order.from, from);
  strips.at(-1) = strips.at(Rows<Word>::chunks) = strips.at(Rows<Word>::chunks + 1) = Strip<Word>{};
  for (int i = 0; i < Rows<Word>::chunks; ++i) {
    Strip<Word>& strip = strips.at(i);
    strip.last = from.chunk[i];
    strip.unreached = ~from.chunk[i];
    for (int k = 0; k < kept; ++k) {
      strip.north[k] = enter.north[k].chunk[i];
      strip.south[k] = enter.south[k].chunk[i];
      strip.east[k] = enter.east[k].chunk[i];
      strip.west[k] = enter.west[k].chunk[i];
    }
  }
}

/// Advances from the last layer to the next, in the chunks first to final. Outside of these, no cell of the last layer
/// may be near enough to move in. A move of three cells is one of up to one cell plus one of none or two, which is less
/// work.
template <int Longest, class Word>
[[gnu::always_inline]] inline void advance(Strips<Word>& strips, int first, int final) {
  using Chunk = typename Rows<Word>::Chunk;
  static_assert(Longest == 1 || Longest == 3);
  // The last layer in the chunks to the south, here, to the north and beyond; saved because it is overwritten.
  Chunk south{}, here = strips.at(first).last, north = strips.at(first + 1).last;
  Chunk up_south{}, down = here | (into_south<1, Word>(here, north) & strips.at(first).south[0]);
  for (Strip<Word>*strip = &strips.at(first), *end = &strips.at(final + 1); strip != end; ++strip) {
    const Chunk beyond = strip[2].last;
    const Chunk up = here | (into_north<1, Word>(south, here) & strip[0].north[0]);
    const Chunk down_north = north | (into_south<1, Word>(north, beyond) & strip[1].south[0]);
    const Chunk right = here | ((here << 1) & strip[0].east[0]), left = here | ((here >> 1) & strip[0].west[0]);
    Chunk reached = (up | down) | (right | left);
    if constexpr (Longest > 1) {
      reached |= (into_north<2, Word>(up_south, up) & strip[0].north[1]) |
                 (into_south<2, Word>(down, down_north) & strip[0].south[1]);
      reached |= ((right << 2) & strip[0].east[1]) | ((left >> 2) & strip[0].west[1]);
    }
    strip[0].last = reached & strip[0].unreached;
    strip[0].unreached &= ~reached;
    south = here, here = north, north = beyond;
    up_south = up, down = down_north;
  }
}

/// Breadth-first search where every move of 1 to Longest cells costs one. A layer seldom spans all rows, so only the
/// chunks near the last one are visited, and its distance is written for its own cells alone.
template <class Word, int Longest>
void fill_strips(const FieldOrder& order) {
  using R = Rows<Word>;
  constexpr int reach = (Longest + R::lanes - 1) / R::lanes;
  R* sets = reinterpret_cast<R*>(order.sets);
  R* planes = sets + 1;
  Strips<Word> strips;
  lay_out<Longest>(order, strips);
  __builtin_memset(planes, 0, static_cast<unsigned>(order.planes) * sizeof(R));
  int low = 0, high = R::chunks - 1;
  for (unsigned distance = 1;; ++distance) {
    low = low > reach ? low - reach : 0;
    high = high + reach < R::chunks ? high + reach : R::chunks - 1;
    advance<Longest>(strips, low, high);
    while (low <= high && !any<Word>(strips.at(low).last)) ++low;
    while (low < high && !any<Word>(strips.at(high).last)) --high;
    if (low > high) break;
    for (unsigned bits = distance; bits != 0; bits &= bits - 1) {
      R& plane = planes[__builtin_ctz(bits)];
      for (int i = low; i <= high; ++i) plane.chunk[i] |= strips.at(i).last;
    }
  }
  for (int i = 0; i < R::chunks; ++i) sets[0].chunk[i] = strips.at(i).unreached;
}

}  // namespace
}  // namespace LABMOUSE_KERNEL
}  // namespace labmouse
