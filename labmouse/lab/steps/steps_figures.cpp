#include "labmouse/lab/steps/steps_figures.hpp"

namespace labmouse {

double number_of(const ContestResult& contest, StepsFigure figure) {
  const auto place = static_cast<std::size_t>(figure);
  return place < contest.figures.size() ? number_of(contest.figures[place]).value_or(0.0) : 0.0;
}

}  // namespace labmouse
