// The mice and mazes that the page asks for.
#pragma once

#include <vector>

#include "labmouse/lab/page/request.hpp"
#include "labmouse/lab/races/world.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {

/// The mice of the field `mice`, in its order; all built-in mice of the world if the list is empty. Mice that the world
/// refuses are errors of the request.
/// @param world null has no mice.
std::vector<Contestant> read_mice(PageRequest& request, const World* world);

/// The mazes of the field `mazes`. Two of the same name, and those that the world refuses, are errors of the request.
/// @param world null refuses none.
std::vector<NamedMaze> read_mazes(PageRequest& request, const World* world);

struct GeneratedMazes {
  const Generator* generator = &contest_generator;
  GeneratorOrder order;
};

/// The fields `generator`, `width`, `height`, `loops` (a share from 0 to 1) and `seed`.
GeneratedMazes read_generator(PageRequest& request);

}  // namespace labmouse
