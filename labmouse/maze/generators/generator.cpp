#include "labmouse/maze/generators/generator.hpp"

#include <array>

namespace labmouse {

std::string_view refuses_out_of_range(const GeneratorOrder& order) {
  if (!order.size.valid()) return "the sides of a maze must be 1 to 64 cells";
  if (order.loops < 0 || order.loops > 1000) return "loops must be a share in thousandths, from 0 to 1000";
  return {};
}

std::span<const Generator* const> all_generators() {
  static constexpr std::array generators = {&depth_first_generator, &prim_generator,     &kruskal_generator,
                                            &wilson_generator,      &division_generator, &empty_generator,
                                            &contest_generator};
  return generators;
}

const Generator* find_generator(std::string_view name) {
  for (const Generator* generator : all_generators())
    if (generator->name == name) return generator;
  return nullptr;
}

}  // namespace labmouse
