// The shapes of all requests and answers between the page and the core. The page's TypeScript types are generated from
// them, and tests check the answers against them.
#pragma once

#include <string_view>

#include "labmouse/lab/shapes/shape.hpp"

namespace labmouse {

/// Whether binary data is sent beside a request.
enum class CallBytes { none, optional, some };

/// A function of the core that the page can call.
struct CallShape {
  std::string name, meaning;
  Shape request, answer;
  CallBytes bytes = CallBytes::none;
};

/// The named shapes by subject, and the calls in the order of `page_calls`.
std::vector<Declaration> maze_shapes();
std::vector<Declaration> about_shapes();
std::vector<Declaration> play_shapes();
std::vector<Declaration> drive_shapes();
std::vector<Declaration> robot_shapes();
std::vector<Declaration> race_shapes();
std::vector<Declaration> external_shapes();
std::vector<Declaration> live_shapes();
std::vector<CallShape> call_shapes();

/// All named shapes.
const std::vector<Declaration>& all_shapes();

/// The shape with that name; null where there is none.
const Shape* find_shape(std::string_view name);

}  // namespace labmouse
