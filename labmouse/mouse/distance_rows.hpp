// The searches behind DistanceField, compiled once for each width of vector.
//
// The .cpp that includes it defines LABMOUSE_KERNEL (the namespace) and LABMOUSE_CHUNK (bytes of a vector). It must not
// use inline functions from anywhere else: the linker keeps one copy of such a function, and that could be one with
// instructions that another processor lacks.
#pragma once

#include "labmouse/mouse/distance_kernel.hpp"

#if LABMOUSE_CHUNK == 32
#include <immintrin.h>
#endif

// clang leaves loops of a few chunks as they are, unless it is asked; g++ unrolls them itself.
#if defined(__clang__)
#define LABMOUSE_UNROLL _Pragma("clang loop unroll(full)")
#else
#define LABMOUSE_UNROLL
#endif

namespace labmouse {

namespace LABMOUSE_KERNEL {
namespace {

/// A whole set of cells: as many rows as a row has bits, in chunks of one vector.
template <class Word>
struct Rows {
  static constexpr int side = 8 * static_cast<int>(sizeof(Word));
  static constexpr int lanes = LABMOUSE_CHUNK / static_cast<int>(sizeof(Word));
  static constexpr int chunks = side / lanes;
  typedef Word Chunk __attribute__((vector_size(LABMOUSE_CHUNK), may_alias));

  Chunk chunk[chunks];
};

template <class Word>
[[gnu::always_inline]] inline bool any(typename Rows<Word>::Chunk chunk) {
#if LABMOUSE_CHUNK == 32
  return _mm256_testz_si256(reinterpret_cast<__m256i>(chunk), reinterpret_cast<__m256i>(chunk)) == 0;
#elif defined(__wasm_simd128__)
  typedef signed char Bytes __attribute__((vector_size(LABMOUSE_CHUNK)));
  return __builtin_wasm_any_true_v128(reinterpret_cast<Bytes>(chunk)) != 0;
#else
  typedef std::uint64_t Wide __attribute__((vector_size(LABMOUSE_CHUNK)));
  const Wide wide = reinterpret_cast<Wide>(chunk);
  std::uint64_t bits = 0;
  for (unsigned i = 0; i < LABMOUSE_CHUNK / 8; ++i) bits |= wide[i];
  return bits != 0;
#endif
}

template <class Word>
[[gnu::always_inline]] inline bool empty(const Rows<Word>& rows) {
  typename Rows<Word>::Chunk all = rows.chunk[0];
  for (int i = 1; i < Rows<Word>::chunks; ++i) all |= rows.chunk[i];
  return !any<Word>(all);
}

template <int... Is>
struct Lanes {};
template <int N, int... Is>
struct CountLanes : CountLanes<N - 1, N - 1, Is...> {};
template <int... Is>
struct CountLanes<0, Is...> {
  using type = Lanes<Is...>;
};

/// The window of one chunk's length that begins `First` lanes into the pair (low, high).
template <int First, class Chunk, int... Is>
[[gnu::always_inline]] inline Chunk window(Chunk low, Chunk high, Lanes<Is...>) {
  return __builtin_shufflevector(low, high, (Is + First)...);
}

/// Chunk i of the set moved K rows north (up) or south: row y goes to row y + K, or y - K; empty rows come in.
template <int K, class Word>
[[gnu::always_inline]] inline typename Rows<Word>::Chunk north(const Rows<Word>& rows, int i) {
  using R = Rows<Word>;
  constexpr int whole = K / R::lanes, part = K % R::lanes;
  const typename R::Chunk high = i - whole >= 0 ? rows.chunk[i - whole] : typename R::Chunk{};
  if constexpr (part == 0) return high;
  const typename R::Chunk low = i - whole - 1 >= 0 ? rows.chunk[i - whole - 1] : typename R::Chunk{};
  return window<R::lanes - part>(low, high, typename CountLanes<R::lanes>::type{});
}
template <int K, class Word>
[[gnu::always_inline]] inline typename Rows<Word>::Chunk south(const Rows<Word>& rows, int i) {
  using R = Rows<Word>;
  constexpr int whole = K / R::lanes, part = K % R::lanes;
  const typename R::Chunk low = i + whole < R::chunks ? rows.chunk[i + whole] : typename R::Chunk{};
  if constexpr (part == 0) return low;
  const typename R::Chunk high = i + whole + 1 < R::chunks ? rows.chunk[i + whole + 1] : typename R::Chunk{};
  return window<part>(low, high, typename CountLanes<R::lanes>::type{});
}

/// Reads 64 rows of 64 bits as rows of this width; what is cut off is empty.
template <class Word>
[[gnu::always_inline]] inline void narrow(const std::uint64_t* wide, Rows<Word>& rows) {
  Word words[Rows<Word>::side];
  for (int y = 0; y < Rows<Word>::side; ++y) words[y] = static_cast<Word>(wide[y]);
  __builtin_memcpy(&rows, words, sizeof rows);
}

/// Adds one to the distance of all cells of the set; they all have distance - 1 now, so the carry goes equally far in all.
template <class Word>
[[gnu::always_inline]] inline void count_up(Rows<Word>* planes, const Rows<Word>& cells, unsigned distance) {
  const int flips = __builtin_ctz(distance) + 1;
  for (int k = 0; k < flips; ++k)
    for (int i = 0; i < Rows<Word>::chunks; ++i) planes[k].chunk[i] ^= cells.chunk[i];
}

/// The cells that can be entered by a straight move of exactly k cells, k = 1 to K, in each of the four directions.
template <class Word, int K>
struct Entries {
  Rows<Word> north[K], south[K], east[K], west[K];
};

template <int K, class Word, int Longest>
[[gnu::always_inline]] inline void extend(Entries<Word, Longest>& enter) {
  for (int i = 0; i < Rows<Word>::chunks; ++i) {
    enter.north[K].chunk[i] = enter.north[0].chunk[i] & north<1>(enter.north[K - 1], i);
    enter.south[K].chunk[i] = enter.south[0].chunk[i] & south<1>(enter.south[K - 1], i);
    enter.east[K].chunk[i] = enter.east[0].chunk[i] & (enter.east[K - 1].chunk[i] << 1);
    enter.west[K].chunk[i] = enter.west[0].chunk[i] & (enter.west[K - 1].chunk[i] >> 1);
  }
  if constexpr (K + 1 < Longest) extend<K + 1>(enter);
}

template <int Longest, class Word>
[[gnu::always_inline]] inline void find_entries(const FieldOrder& order, Entries<Word, Longest>& enter) {
  Rows<Word> passage_east;
  narrow(order.north, enter.south[0]);
  narrow(order.east, passage_east);
  for (int i = 0; i < Rows<Word>::chunks; ++i) {
    enter.north[0].chunk[i] = north<1>(enter.south[0], i);
    enter.west[0].chunk[i] = passage_east.chunk[i];
    enter.east[0].chunk[i] = passage_east.chunk[i] << 1;
  }
  if constexpr (Longest > 1) extend<1>(enter);
}

/// Chunk i of the cells that one move of 1 to K cells leads to.
template <int K, class Word, int Longest>
[[gnu::always_inline]] inline typename Rows<Word>::Chunk moved(const Rows<Word>& last,
                                                               const Entries<Word, Longest>& enter, int i) {
  const typename Rows<Word>::Chunk here =
      ((north<K>(last, i) & enter.north[K - 1].chunk[i]) | (south<K>(last, i) & enter.south[K - 1].chunk[i])) |
      (((last.chunk[i] << K) & enter.east[K - 1].chunk[i]) | ((last.chunk[i] >> K) & enter.west[K - 1].chunk[i]));
  if constexpr (K == 1)
    return here;
  else
    return here | moved<K - 1>(last, enter, i);
}

/// Every move of 1 to Longest cells costs one: layer after layer, each over the whole set, in loops that the compiler
/// unrolls.
template <class Word, int Longest>
void fill_layers(const FieldOrder& order) {
  using R = Rows<Word>;
  R* sets = reinterpret_cast<R*>(order.sets);
  R* planes = sets + 1;
  Entries<Word, Longest> enter;
  find_entries<Longest>(order, enter);
  R last, unreached;
  narrow(order.from, last);
  for (int i = 0; i < R::chunks; ++i) unreached.chunk[i] = ~last.chunk[i];
  __builtin_memset(planes, 0, static_cast<unsigned>(order.planes) * sizeof(R));
  for (unsigned distance = 1;; ++distance) {
    R next;
    LABMOUSE_UNROLL
    for (int i = 0; i < R::chunks; ++i) next.chunk[i] = moved<Longest>(last, enter, i) & unreached.chunk[i];
    if (empty(next)) break;
    count_up(planes, unreached, distance);
    LABMOUSE_UNROLL
    for (int i = 0; i < R::chunks; ++i) unreached.chunk[i] &= ~next.chunk[i];
    last = next;
  }
  sets[0] = unreached;
}

/// One chunk of all sets that a layer of a large maze needs, side by side: one address for all of them.
template <class Word>
struct Strip {
  using Chunk = typename Rows<Word>::Chunk;

  Chunk last;       ///< the cells of the last layer
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

/// Goes from the last layer to the next one, from chunk first to final; outside of these the last one must be so empty
/// that nothing comes in. Moves of three cells are one of up to one cell and one of none or two, which is less to do.
template <int Longest, class Word>
[[gnu::always_inline]] inline void advance(Strips<Word>& strips, int first, int final) {
  using Chunk = typename Rows<Word>::Chunk;
  static_assert(Longest == 1 || Longest == 3);
  // What the last layer was in the chunk to the south, here, to the north and beyond, while it is written over.
  Chunk south{}, here = strips.at(first).last, north = strips.at(first + 1).last;
  Chunk up_south{}, down = here | (into_south<1, Word>(here, north) & strips.at(first).south[0]);
  for (Strip<Word>*strip = &strips.at(first), *end = &strips.at(final + 1); strip != end; ++strip) {
    const Chunk beyond = strip[2].last;
    const Chunk up = here | (into_north<1, Word>(south, here) & strip[0].north[0]);
    const Chunk down_north = north | (into_south<1, Word>(north, beyond) & strip[1].south[0]);
    const Chunk right = here | ((here << 1) & strip[0].east[0]), left = here | ((here >> 1) & strip[0].west[0]);
    Chunk reached = (up | down) | (right | left);
    if constexpr (Longest > 1) {
      reached |= (into_north<2, Word>(up_south, up) & strip[0].north[1]) | (into_south<2, Word>(down, down_north) & strip[0].south[1]);
      reached |= ((right << 2) & strip[0].east[1]) | ((left >> 2) & strip[0].west[1]);
    }
    strip[0].last = reached & strip[0].unreached;
    strip[0].unreached &= ~reached;
    south = here, here = north, north = beyond;
    up_south = up, down = down_north;
  }
}

/// The same for many chunks. A layer seldom spans all rows, so only those near the last one are looked at, and its
/// distance is written down for its own cells alone.
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

/// Puts the cells that a straight run leads to into the buckets of their costs.
template <class Word>
[[gnu::always_inline]] inline void spread(const FieldOrder& order, const Entries<Word, 1>& enter, const Rows<Word>& settled,
                                          unsigned distance, Rows<Word>* ring) {
  const auto buckets = static_cast<unsigned>(order.cost[order.longest]) + 1;
  Rows<Word> to_north = settled, to_south = settled, to_east = settled, to_west = settled;
  for (int k = 1; k <= order.longest; ++k) {
    Rows<Word>& later = ring[(distance + order.cost[k]) % buckets];
    const Rows<Word> from_south = to_north, from_north = to_south;
    for (int i = 0; i < Rows<Word>::chunks; ++i) {
      to_north.chunk[i] = north<1>(from_south, i) & enter.north[0].chunk[i];
      to_south.chunk[i] = south<1>(from_north, i) & enter.south[0].chunk[i];
      to_east.chunk[i] = (to_east.chunk[i] << 1) & enter.east[0].chunk[i];
      to_west.chunk[i] = (to_west.chunk[i] >> 1) & enter.west[0].chunk[i];
      later.chunk[i] |= (to_north.chunk[i] | to_south.chunk[i]) | (to_east.chunk[i] | to_west.chunk[i]);
    }
  }
}

/// Any costs: a ring of buckets, one for each cost that may still come (Dial's algorithm, with sets for its lists).
template <class Word>
void fill_buckets(const FieldOrder& order) {
  using R = Rows<Word>;
  R* sets = reinterpret_cast<R*>(order.sets);
  R* planes = sets + 1;
  R* ring = planes + order.planes;
  const int dearest = order.cost[order.longest];
  Entries<Word, 1> enter;
  find_entries<1>(order, enter);
  R unreached;
  for (int i = 0; i < R::chunks; ++i) unreached.chunk[i] = ~typename R::Chunk{};
  __builtin_memset(planes, 0, static_cast<unsigned>(order.planes + dearest + 1) * sizeof(R));
  narrow(order.from, ring[0]);
  int idle = 0;  // buckets found empty in a row: after a whole round nothing can come any more
  for (unsigned distance = 0; idle <= dearest; ++distance) {
    if (distance > 0) count_up(planes, unreached, distance);
    R& bucket = ring[distance % static_cast<unsigned>(dearest + 1)];
    R settled;
    for (int i = 0; i < R::chunks; ++i) {
      settled.chunk[i] = bucket.chunk[i] & unreached.chunk[i];
      unreached.chunk[i] &= ~settled.chunk[i];
      bucket.chunk[i] = typename R::Chunk{};
    }
    if (empty(settled)) {
      ++idle;
      continue;
    }
    idle = 0;
    spread(order, enter, settled, distance, ring);
  }
  sets[0] = unreached;
}

template <class Word, int Longest>
constexpr Kernel kernel_for_layers() {
  constexpr int few = 4;  // chunks
  if constexpr (Rows<Word>::chunks <= few) return fill_layers<Word, Longest>;
  return fill_strips<Word, Longest>;
}

template <class Word>
Kernel kernel_for_rows(int longest, bool uniform) {
  if (uniform && longest == 1) return kernel_for_layers<Word, 1>();
  if (uniform && longest == 3) return kernel_for_layers<Word, 3>();
  return fill_buckets<Word>;
}

}  // namespace

Kernel kernel_for(int row_bits, int longest, bool uniform) {
  if (row_bits == 16) return kernel_for_rows<std::uint16_t>(longest, uniform);
  if (row_bits == 32) return kernel_for_rows<std::uint32_t>(longest, uniform);
  return kernel_for_rows<std::uint64_t>(longest, uniform);
}

}  // namespace LABMOUSE_KERNEL
}  // namespace labmouse
