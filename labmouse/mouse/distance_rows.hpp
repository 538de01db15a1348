// Sets of cells as rows of bits in vectors, for the searches behind DistanceField.
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

/// Adds one to the distance of all cells of the set; they all have distance - 1 now, so the carry goes equally far in
/// all.
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

}  // namespace
}  // namespace LABMOUSE_KERNEL
}  // namespace labmouse
