// A priority queue of edges of a maze, by time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse {

/// A heap of edges. Each is in it at most once, and its place is stored, so that it can be moved forward: Dijkstra's
/// search needs no more room than one place an edge.
class EdgeHeap {
 public:
  /// The place of an edge that is not queued. Numbers of edges are below it.
  static constexpr std::uint16_t nowhere = 0xffff;

  /// Without room for any edge.
  EdgeHeap() = default;
  /// Uses arrays of the caller, one element an edge, which must outlive it. Call clear() before all else.
  /// @param heap for the edges in the order of the heap.
  /// @param places for the place of each edge.
  /// @param times by edge, in microseconds; the caller writes them, the least comes first.
  EdgeHeap(std::uint16_t* heap, std::uint16_t* places, const DriveTime* times)
      : heap_(heap), places_(places), times_(times) {}

  /// Empties the queue.
  /// @param edges the number of all edges: the length of the arrays, at most `nowhere`.
  void clear(std::size_t edges) {
    size_ = 0;
    for (std::size_t edge = 0; edge < edges; ++edge) places_[edge] = nowhere;
  }
  /// Whether no edge is queued.
  bool empty() const { return size_ == 0; }
  /// Whether an edge is queued.
  /// @param edge its number.
  bool contains(std::size_t edge) const { return places_[edge] != nowhere; }
  /// Inserts an edge, or moves it forward after its time has decreased.
  /// @param edge its number; its time must be written before.
  void reach(std::size_t edge) {
    std::size_t place = places_[edge];
    if (place == nowhere) place = size_++;
    for (; place > 0 && times_[edge] < times_[heap_[(place - 1) / 2]]; place = (place - 1) / 2)
      put(heap_[(place - 1) / 2], place);
    put(edge, place);
  }
  /// The edge with the least time.
  /// @pre The queue is not empty.
  std::size_t first() const { return heap_[0]; }
  /// Removes and returns the edge with the least time.
  /// @pre The queue is not empty.
  std::size_t take() {
    const std::size_t first = heap_[0], last = heap_[--size_];
    places_[first] = nowhere;
    if (size_ > 0) put_off(last, 0);
    return first;
  }
  /// Removes an edge, if it is queued.
  /// @param edge its number.
  void remove(std::size_t edge) {
    const std::size_t place = places_[edge];
    if (place == nowhere) return;
    places_[edge] = nowhere;
    const std::size_t last = heap_[--size_];
    if (place == size_) return;
    put_off(last, place);
    reach(last);
  }

 private:
  /// Puts an edge into a free place, or moves it back from there.
  void put_off(std::size_t edge, std::size_t place) {
    for (std::size_t next = 2 * place + 1; next < size_; next = 2 * place + 1) {
      if (next + 1 < size_ && times_[heap_[next + 1]] < times_[heap_[next]]) ++next;
      if (times_[edge] <= times_[heap_[next]]) break;
      put(heap_[next], std::exchange(place, next));
    }
    put(edge, place);
  }
  void put(std::size_t edge, std::size_t place) {
    heap_[place] = static_cast<std::uint16_t>(edge);
    places_[edge] = static_cast<std::uint16_t>(place);
  }

  std::uint16_t* heap_ = nullptr;
  std::uint16_t* places_ = nullptr;  ///< by edge
  const DriveTime* times_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace labmouse
