// Texts that are too long to be held whole: made part by part, and taken part by part.
#pragma once

#include <functional>
#include <string_view>

namespace labmouse {

/// Takes the next part of a text.
using TextSink = std::function<void(std::string_view part)>;

/// Hands a text over, from its first part to its last.
using TextSource = std::function<void(const TextSink& sink)>;

}  // namespace labmouse
