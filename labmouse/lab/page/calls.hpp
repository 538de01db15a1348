// The interface between web page and lab: named calls with a request and an answer in JSON. labmouse/lab/shapes defines
// their types.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace labmouse {

/// An answer: JSON, `{"answer":{...}}` or `{"failure":{"error":...,"problems":[...]}}`, and binary data, which most
/// calls do not have.
struct PageAnswer {
  std::string json;
  std::string bytes;
};

/// Answers one call; errors in the request or in a file become a failure. `bytes` is binary data of the request, empty
/// for most calls.
PageAnswer answer_page(std::string_view call, std::string_view request, std::string_view bytes);

/// The names of all calls.
std::span<const std::string_view> page_calls();

}  // namespace labmouse
