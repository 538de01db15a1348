#include "labmouse/lab/page/calls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

using Answering = PageReply (*)(const ReadJson& request, std::string_view bytes);

struct Call {
  std::string_view name;
  Answering answer;
};

constexpr std::array calls = {
    Call{"about", answer_about},
    Call{"signature", answer_signature},
    Call{"speed", answer_speed},
    Call{"builtin_maze", answer_builtin_maze},
    Call{"make_maze", answer_make_maze},
    Call{"open", answer_open},
    Call{"inspect", answer_inspect},
    Call{"write_maze", answer_write_maze},
    Call{"link", answer_link},
    Call{"read_link", answer_read_link},
    Call{"contest", answer_contest},
    Call{"robot", answer_robot},
    Call{"regions", answer_regions},
    Call{"unpack", answer_unpack},
    Call{"race", answer_race},
    Call{"compare", answer_compare},
    Call{"paired_shares", answer_paired_shares},
    Call{"verdict", answer_verdict},
    Call{"losses", answer_losses},
    Call{"beliefs", answer_beliefs},
    Call{"picture", answer_picture},
    Call{"program_begin", answer_external_begin},
    Call{"program_hear", answer_external_hear},
    Call{"program_end", answer_external_end},
    Call{"live_begin", answer_live_begin},
    Call{"live_feed", answer_live_feed},
    Call{"live_end", answer_live_end},
};

constexpr auto call_names = [] {
  std::array<std::string_view, calls.size()> list;
  for (std::size_t i = 0; i < calls.size(); ++i) list[i] = calls[i].name;
  return list;
}();

PageAnswer failure(const PageFailure& failure) {
  Json problems = Json::array();
  for (const Problem& problem : failure.problems)
    problems.push_back({{"line", problem.line}, {"column", problem.column}, {"reason", problem.reason}});
  const Json json = {{"failure", {{"error", failure.error}, {"problems", std::move(problems)}}}};
  return {one_line(json), ""};
}

}  // namespace

PageAnswer answer_page(std::string_view call, std::string_view request, std::string_view bytes) {
  const auto found = std::find_if(calls.begin(), calls.end(), [&](const Call& c) { return c.name == call; });
  if (found == calls.end()) return failure({fmt::format("the page has no call '{}'", call), {}});
  const ReadJson json = read_json(request);
  if (!json.is_object()) return failure({"the request is not a JSON object", {}});
  PageReply reply = found->answer(json, bytes);
  if (!reply.failure.error.empty()) return failure(reply.failure);
  const std::string answer = one_line(reply.answer);
  return {"{\"answer\":" + answer + "}", std::move(reply.bytes)};
}

std::span<const std::string_view> page_calls() { return call_names; }

}  // namespace labmouse
