#include "labmouse/lab/standings/mouse_figures.hpp"

#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {
namespace {

/// The field of that name; null where the world has none.
const ContestField* field_of(const Race& race, std::string_view figure) {
  for (const ContestField& field : race.world().traits().fields->contest)
    if (field.key == figure) return &field;
  return nullptr;
}

class Numbers {
 public:
  Numbers(const Race& race, std::string_view figure) : race_(race), field_(field_of(race, figure)) {}

  void add(const ContestResult& contest) {
    if (field_ == nullptr) return;
    if (const auto number = number_of(field_->of(race_, contest))) values.push_back(*number);
  }

  std::vector<double> values;

 private:
  const Race& race_;
  const ContestField* field_;
};

}  // namespace

std::optional<double> mean_if_any(std::span<const double> values) {
  return values.empty() ? std::nullopt : std::optional(mean(values));
}

std::optional<double> mean_finished(const Race& race, const Standing& standing, std::string_view figure) {
  Numbers numbers(race, figure);
  for_each_finished(race, standing, [&](const ContestResult& contest) { numbers.add(contest); });
  return mean_if_any(numbers.values);
}

std::optional<double> mean_of_all(const Race& race, const Standing& standing, std::string_view figure) {
  Numbers numbers(race, figure);
  for_each_counted(race, standing, [&](const ContestResult& contest) { numbers.add(contest); });
  return mean_if_any(numbers.values);
}

}  // namespace labmouse
