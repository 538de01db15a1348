// The answers to the page's calls, one function a call. labmouse/lab/shapes defines requests and answers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// Why a call failed: a line for the user, and the places of errors in the input.
struct PageFailure {
  std::string error;
  std::vector<Problem> problems;
};

/// An answer, or a failure if `failure.error` is not empty.
struct PageReply {
  Json answer;
  std::string bytes;
  PageFailure failure;
};

inline PageReply answered(Json answer) { return {std::move(answer), "", {}}; }
inline PageReply failed(std::string error, std::vector<Problem> problems = {}) {
  return {nullptr, "", {std::move(error), std::move(problems)}};
}

PageReply answer_about(const ReadJson& request, std::string_view bytes);
PageReply answer_signature(const ReadJson& request, std::string_view bytes);
PageReply answer_speed(const ReadJson& request, std::string_view bytes);
PageReply answer_builtin_maze(const ReadJson& request, std::string_view bytes);
PageReply answer_make_maze(const ReadJson& request, std::string_view bytes);
PageReply answer_open(const ReadJson& request, std::string_view bytes);
PageReply answer_inspect(const ReadJson& request, std::string_view bytes);
PageReply answer_write_maze(const ReadJson& request, std::string_view bytes);
PageReply answer_link(const ReadJson& request, std::string_view bytes);
PageReply answer_read_link(const ReadJson& request, std::string_view bytes);
PageReply answer_contest(const ReadJson& request, std::string_view bytes);
PageReply answer_robot(const ReadJson& request, std::string_view bytes);
PageReply answer_regions(const ReadJson& request, std::string_view bytes);
PageReply answer_unpack(const ReadJson& request, std::string_view bytes);
PageReply answer_race(const ReadJson& request, std::string_view bytes);
PageReply answer_paired_shares(const ReadJson& request, std::string_view bytes);
PageReply answer_verdict(const ReadJson& request, std::string_view bytes);
PageReply answer_compare(const ReadJson& request, std::string_view bytes);
PageReply answer_losses(const ReadJson& request, std::string_view bytes);
PageReply answer_beliefs(const ReadJson& request, std::string_view bytes);
PageReply answer_picture(const ReadJson& request, std::string_view bytes);
PageReply answer_external_begin(const ReadJson& request, std::string_view bytes);
PageReply answer_external_hear(const ReadJson& request, std::string_view bytes);
PageReply answer_external_end(const ReadJson& request, std::string_view bytes);
PageReply answer_live_begin(const ReadJson& request, std::string_view bytes);
PageReply answer_live_feed(const ReadJson& request, std::string_view bytes);
PageReply answer_live_end(const ReadJson& request, std::string_view bytes);

}  // namespace labmouse
