// What the page asks of the lab: each call a name with a request in JSON, answered in JSON. The shapes of both are
// in labmouse/lab/shapes.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace labmouse {

/// An answer: JSON, `{"answer":{...}}` or `{"failure":{"error":...,"problems":[...]}}`, and what goes beside it as
/// bytes.
struct PageAnswer {
  std::string json;
  std::string bytes;
};

/// Answers one call; what is wrong with a request or with a file is a failure in words. `bytes` goes beside the request
/// and is empty for most.
PageAnswer answer_page(std::string_view call, std::string_view request, std::string_view bytes);

/// The names of all calls.
std::span<const std::string_view> page_calls();

}  // namespace labmouse
