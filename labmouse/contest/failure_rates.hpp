// Failure rates: of each manoeuvre and each wall reading, by the localization error and the severity of the mouse's
// draws. labmouse/lab/failure rates counts them in the physical world; the failure model draws errors at these rates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "labmouse/contest/draws.hpp"
#include "labmouse/contest/manoeuvre.hpp"
#include "labmouse/mouse/evidence.hpp"

namespace labmouse {

/// Of a manoeuvre that begins with a mouse as far off its believed position. All are from 0 to 1.
struct ManoeuvreRates {
  double crash = 0.0;
  double slid = 0.0;  ///< the part of crashes in which the tyres did not hold
  std::array<double, position_error_levels> after = {
      1.0};  ///< how far off its believed position it is behind, where it did not crash
};

/// Classes of evidence: as many nats for a gap, nothing, as many nats for a wall.
inline constexpr int most_nats_told = 8;
inline constexpr std::size_t evidence_classes = 2 * most_nats_told + 1;

/// The class of a reading's evidence: of up to one nat, of up to two...
constexpr std::size_t evidence_class(Evidence evidence) {
  const int size = evidence < 0 ? -evidence : evidence;
  const int nats = (size + evidence_a_nat - 1) / evidence_a_nat;
  const int most = nats < most_nats_told ? nats : most_nats_told;
  return static_cast<std::size_t>(most_nats_told + (evidence < 0 ? -most : most));
}

/// The evidence in the middle of a class.
constexpr Evidence evidence_in(std::size_t place) {
  const int nats = static_cast<int>(place) - most_nats_told;
  const int eighths = evidence_a_nat * nats + (nats < 0 ? evidence_a_nat / 2 : nats > 0 ? -evidence_a_nat / 2 : 0);
  return static_cast<Evidence>(eighths);
}

/// The shares of all classes of evidence.
using ReadingRates = std::array<double, evidence_classes>;

/// Of contests as lucky as each other.
struct FailureRatesByDraw {
  std::array<double, position_error_levels> put = {
      1.0};  ///< how far off its believed position a mouse is whom a hand has put at the start
  std::array<std::array<ManoeuvreRates, position_error_levels>, all_manoeuvres.size()> manoeuvres{};
  std::array<std::array<ReadingRates, position_error_levels>, all_readings.size()> readings{};
};

/// Under one noise.
struct RatesAtNoise {
  double noise = 0.0;
  std::array<FailureRatesByDraw, draw_classes> by_draws{};
};

/// Driven at that part of the usual pace.
struct RatesAtPace {
  double pace = 1.0;
  std::vector<RatesAtNoise> noises;  ///< by increasing noise, at least one
};

struct FailureRates {
  double variation = 1.0;          ///< of the contests' draws
  std::vector<RatesAtPace> paces;  ///< by increasing pace, at least one
};

/// Two places of a list, and how much of the way from the one to the other a value is.
struct Between {
  std::size_t below = 0, above = 0;
  double part = 0.0;
};

/// The places of a list of increasing keys next to a key; one place twice where the key is there, or beyond the ends.
template <class List, class Key>
Between between(const List& list, double key, Key key_of) {
  std::size_t above = 0;
  while (above < list.size() && key_of(list[above]) < key) ++above;
  if (above == list.size()) return {above - 1, above - 1, 0.0};
  if (above == 0 || key_of(list[above]) == key) return {above, above, 0.0};
  const double low = key_of(list[above - 1]);
  return {above - 1, above, (key - low) / (key_of(list[above]) - low)};
}

/// In which nothing goes wrong: noise 0.
RatesAtNoise no_failures();

}  // namespace labmouse
