// The searches behind DistanceField, compiled once for each width of vector; see distance_rows.hpp.
#pragma once

#include "labmouse/mouse/distance_strips.hpp"

// clang does not unroll loops of a few chunks by itself; g++ does.
#if defined(__clang__)
#define LABMOUSE_UNROLL _Pragma("clang loop unroll(full)")
#else
#define LABMOUSE_UNROLL
#endif

namespace labmouse {

namespace LABMOUSE_KERNEL {
namespace {

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

/// Breadth-first search where every move of 1 to Longest cells costs one: each layer covers the whole set, in loops
/// that the compiler unrolls.
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

/// Puts the cells that a straight run leads to into the buckets of their costs.
template <class Word>
[[gnu::always_inline]] inline void spread(const FieldOrder& order, const Entries<Word, 1>& enter,
                                          const Rows<Word>& settled, unsigned distance, Rows<Word>* ring) {
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
