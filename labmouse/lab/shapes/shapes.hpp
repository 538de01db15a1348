// Every shape of the page, once: what each call is asked and what it answers. The page's TypeScript types are written
// from these, and tests check the answers against them.
#pragma once

#include <string_view>

#include "labmouse/lab/shapes/shape.hpp"

namespace labmouse {

/// Whether bytes go beside a request.
enum class CallBytes { none, optional, some };

/// A call of the page.
struct CallShape {
  std::string name, meaning;
  Shape request, answer;
  CallBytes bytes = CallBytes::none;
};

/// The named shapes, by what they are about; and the calls, in the order of `page_calls`.
std::vector<Declaration> maze_shapes();
std::vector<Declaration> about_shapes();
std::vector<Declaration> play_shapes();
std::vector<Declaration> drive_shapes();
std::vector<Declaration> robot_shapes();
std::vector<Declaration> race_shapes();
std::vector<Declaration> external_shapes();
std::vector<CallShape> call_shapes();

/// All named shapes.
const std::vector<Declaration>& all_shapes();

/// The shape of that name; null where there is none.
const Shape* find_shape(std::string_view name);

}  // namespace labmouse
