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

/// The chunks first to final. A layer of a large maze seldom spans all rows, so only those near the last one are looked
/// at; a small set is done faster whole, in a loop that the compiler unrolls.
template <class Word, int Reach>
struct Window {
  using R = Rows<Word>;
  static constexpr bool whole = R::chunks <= 4;
  int low = 0, high = R::chunks - 1;

  [[gnu::always_inline]] int first() const { return whole ? 0 : low; }
  [[gnu::always_inline]] int final() const { return whole ? R::chunks - 1 : high; }

  [[gnu::always_inline]] void widen() {
    low = low > Reach ? low - Reach : 0;
    high = high + Reach < R::chunks ? high + Reach : R::chunks - 1;
  }
  /// Shrinks to what the set fills; false where that is nothing.
  [[gnu::always_inline]] bool shrink(const R& rows) {
    if constexpr (whole) return !empty(rows);
    while (low <= high && !any<Word>(rows.chunk[low])) ++low;
    while (low < high && !any<Word>(rows.chunk[high])) --high;
    return low <= high;
  }
};

/// Every move of 1 to Longest cells costs one: layer after layer. `last` stays empty outside of the window.
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
  Window<Word, (Longest + R::lanes - 1) / R::lanes> window;
  for (unsigned distance = 1;; ++distance) {
    window.widen();
    const int first = window.first(), final = window.final();
    R next;
    for (int i = first; i <= final; ++i) next.chunk[i] = moved<Longest>(last, enter, i) & unreached.chunk[i];
    if (!window.shrink(next)) break;
    count_up(planes, unreached, distance);
    for (int i = first; i <= final; ++i) {
      unreached.chunk[i] &= ~next.chunk[i];
      last.chunk[i] = next.chunk[i];
    }
  }
  sets[0] = unreached;
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

template <class Word>
Kernel kernel_for_rows(int longest, bool uniform) {
  if (uniform && longest == 1) return fill_layers<Word, 1>;
  if (uniform && longest == 3) return fill_layers<Word, 3>;
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
