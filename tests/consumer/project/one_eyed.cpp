// A mouse from outside: it looks to its right and ahead only, runs in a maze made here, and its score is printed.
#include <cstdio>
#include <string>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/explorer.hpp"

namespace {

class OneEyed final : public labmouse::Explorer {
 public:
  using Explorer::Explorer;

 private:
  labmouse::Action explore() override {
    if (goal_entered()) return labmouse::Action::reset();
    if (seen().right > 0) return labmouse::Action::step(90, 1);
    if (seen().ahead > 0) return labmouse::Action::step(0, 1);
    return labmouse::Action::step(-90, 0);
  }
};

}  // namespace

int main() {
  const labmouse::Maze maze = labmouse::find_generator("kruskal")->make({{8, 8}, 7, 0});
  const labmouse::Rules rules;
  OneEyed mouse(labmouse::brief(maze, rules, 1));
  const labmouse::Score score = labmouse::score(labmouse::run(maze, rules, mouse), rules);
  const std::string outcome(labmouse::name_of(score.outcome));
  std::printf("one-eyed scores %.3f (%s)\n", score.value.value_or(rules.failure_score), outcome.c_str());
}
