// The answers to the page's calls, one function a call. apps/web/page/src/core/types.ts lists what each is asked and what
// it answers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// Why a call cannot be answered: a line for people, and where the input is wrong.
struct PageFailure {
  std::string error;
  std::vector<Problem> problems;
};

/// An answer, or a failure where its error is not empty.
struct PageReply {
  nlohmann::ordered_json answer;
  std::string bytes;
  PageFailure failure;
};

PageReply answer_about(const nlohmann::json& request, std::string_view bytes);
PageReply answer_signature(const nlohmann::json& request, std::string_view bytes);

}  // namespace labmouse
