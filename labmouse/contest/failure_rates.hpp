// Failure rates of each manoeuvre and each wall reading, by the localization error and by how bright walls look.
// labmouse/lab/failure_rates measures them in the physical world; the failure model draws errors at these rates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "labmouse/contest/brightness.hpp"
#include "labmouse/contest/manoeuvre.hpp"
#include "labmouse/mouse/evidence.hpp"

namespace labmouse {

/// Probabilities (0 to 1) of a manoeuvre, for a given localization error at its beginning.
struct ManoeuvreRates {
  double crash = 0.0;
  double slid = 0.0;  ///< share of the crashes in which the tyres slid
  std::array<double, position_error_levels> after = {
      1.0};  ///< distribution of the localization error afterwards, if it did not crash
};

/// Classes of evidence, each one nat wide: those for a gap, the strongest first; none; those for a wall, the strongest
/// last.
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

/// Rates of one class of brightness: placement and manoeuvres of contests in which walls are that bright on average,
/// and readings of walls that are.
struct FailureRatesByBrightness {
  std::array<double, position_error_levels> put = {
      1.0};  ///< distribution of the localization error after placement at the start by hand
  std::array<std::array<ManoeuvreRates, position_error_levels>, all_manoeuvres.size()> manoeuvres{};
  std::array<std::array<ReadingRates, position_error_levels>, all_readings.size()> readings{};
};

/// Rates at one scale of the variation.
struct RatesAtVariation {
  double variation = 0.0;
  std::array<FailureRatesByBrightness, brightness_classes> by_brightness{};
};

/// Rates at one pace, as a share of the usual one.
struct RatesAtPace {
  double pace = 1.0;
  std::vector<RatesAtVariation> variations;  ///< increasing, at least one
};

struct FailureRates {
  double noise = 1.0;              ///< scale of the noise
  std::vector<RatesAtPace> paces;  ///< by increasing pace, at least one
};

/// Two neighbouring indices of a list, and the fraction for linear interpolation between them.
struct Between {
  std::size_t below = 0, above = 0;
  double part = 0.0;
};

/// The indices next to a key in a list of increasing keys; the same index twice if the key is in the list or beyond its
/// ends.
template <class List, class Key>
Between between(const List& list, double key, Key key_of) {
  std::size_t above = 0;
  while (above < list.size() && key_of(list[above]) < key) ++above;
  if (above == list.size()) return {above - 1, above - 1, 0.0};
  if (above == 0 || key_of(list[above]) == key) return {above, above, 0.0};
  const double low = key_of(list[above - 1]);
  return {above - 1, above, (key - low) / (key_of(list[above]) - low)};
}

/// Rates without any failure, at variation 0.
RatesAtVariation no_failures();

}  // namespace labmouse
