// Long texts that are produced and consumed in parts.
#pragma once

#include <functional>
#include <string_view>

namespace labmouse {

/// Consumes the next part of a text.
using TextSink = std::function<void(std::string_view part)>;

/// Produces a text: calls the sink with each part in order.
using TextSource = std::function<void(const TextSink& sink)>;

}  // namespace labmouse
