#include "labmouse/lab/failure_rates/failure_tally.hpp"

#include <numeric>

namespace labmouse {
namespace {

template <class Counts>
void add_all(Counts& sum, const Counts& other) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += other[i];
}

}  // namespace

ManoeuvreCount& ManoeuvreCount::operator+=(const ManoeuvreCount& other) {
  times += other.times;
  crashes += other.crashes;
  slid += other.slid;
  add_all(after, other.after);
  return *this;
}

ReadingCount& ReadingCount::operator+=(const ReadingCount& other) {
  add_all(by_evidence, other.by_evidence);
  return *this;
}

std::int64_t ReadingCount::times() const {
  return std::accumulate(by_evidence.begin(), by_evidence.end(), std::int64_t{0});
}

std::int64_t ReadingCount::wrong(Reading reading) const {
  const auto* first = by_evidence.data() + (is_of_wall(reading) ? 0 : most_nats_told + 1);
  return std::accumulate(first, first + most_nats_told, std::int64_t{0});
}

FailureCounts& FailureCounts::operator+=(const FailureCounts& other) {
  contests += other.contests;
  finished += other.finished;
  add_all(put, other.put);
  for (std::size_t i = 0; i < manoeuvres.size(); ++i) add_all(manoeuvres[i], other.manoeuvres[i]);
  for (std::size_t i = 0; i < readings.size(); ++i) add_all(readings[i], other.readings[i]);
  return *this;
}

FailureTally& FailureTally::operator+=(const FailureTally& other) {
  add_all(by_brightness, other.by_brightness);
  return *this;
}

FailureCounts FailureTally::all() const {
  FailureCounts sum;
  for (const FailureCounts& counts : by_brightness) sum += counts;
  return sum;
}

ManoeuvreCount FailureCounts::of(Manoeuvre manoeuvre) const {
  ManoeuvreCount sum;
  for (const ManoeuvreCount& count : manoeuvres[static_cast<std::size_t>(manoeuvre)]) sum += count;
  return sum;
}

ManoeuvreCount FailureCounts::at(std::size_t level) const {
  ManoeuvreCount sum;
  for (const auto& counts : manoeuvres) sum += counts[level];
  return sum;
}

}  // namespace labmouse
