// Calls of the page to test with.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "labmouse/lab/page/calls.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/shapes/shapes.hpp"
#include "tests/lab/page/shape_check.hpp"
#include "tests/lab/races/race_fixture.hpp"

namespace labmouse::test {

using nlohmann::json;

/// What a call with that request says, an answer or a failure.
inline json said(std::string_view call, const json& request, std::string_view bytes = "") {
  return json::parse(answer_page(call, request.dump(), bytes).json);
}

/// The call of that name has such requests and answers as its shape says.
inline void expect_shapes(std::string_view call, const json& request, const json& answer) {
  for (const CallShape& shape : call_shapes()) {
    if (shape.name != call) continue;
    EXPECT_EQ(mismatch(request, shape.request, "request"), "") << call;
    EXPECT_EQ(mismatch(answer, shape.answer, "answer"), "") << call;
  }
}

/// The answer to a call that has to succeed.
inline json answer(std::string_view call, const json& request, std::string_view bytes = "") {
  const json reply = said(call, request, bytes);
  if (!reply.contains("answer")) ADD_FAILURE() << call << ": " << reply.dump();
  if (reply.contains("answer")) expect_shapes(call, request, reply["answer"]);
  return reply.contains("answer") ? reply["answer"] : json::object();
}

/// The failure of a call that has to fail.
inline json failure(std::string_view call, const json& request, std::string_view bytes = "") {
  const json reply = said(call, request, bytes);
  if (!reply.contains("failure")) ADD_FAILURE() << call << " did not fail: " << reply.dump().substr(0, 200);
  return reply.contains("failure") ? reply["failure"] : json{{"error", ""}, {"problems", json::array()}};
}

inline std::string error_of(std::string_view call, const json& request, std::string_view bytes = "") {
  return failure(call, request, bytes)["error"];
}

/// A maze as the page gives it.
inline json data_of(const NamedMaze& maze) { return json::parse(maze_data(maze.name, maze.maze).dump()); }

/// The request with one field changed.
inline json with(json request, const json::json_pointer& field, const json& value) {
  request[field] = value;
  return request;
}

}  // namespace labmouse::test
