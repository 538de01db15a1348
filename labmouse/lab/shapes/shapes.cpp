#include "labmouse/lab/shapes/shapes.hpp"

#include <algorithm>

namespace labmouse {

const std::vector<Declaration>& all_shapes() {
  static const std::vector<Declaration> all = [] {
    std::vector<Declaration> list;
    for (const auto& some : {maze_shapes(), about_shapes(), play_shapes(), drive_shapes(), robot_shapes(),
                             race_shapes(), external_shapes(), live_shapes()})
      list.insert(list.end(), some.begin(), some.end());
    return list;
  }();
  return all;
}

const Shape* find_shape(std::string_view name) {
  const auto& all = all_shapes();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Declaration& one) { return one.name == name; });
  return found == all.end() ? nullptr : &found->shape;
}

}  // namespace labmouse
