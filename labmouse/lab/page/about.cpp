#include <fmt/format.h>

#include "labmouse/lab/builtin_mazes.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/signature.hpp"
#include "labmouse/lab/version.hpp"

namespace labmouse {

PageReply answer_about(const nlohmann::json&, std::string_view) {
  PageReply reply;
  reply.answer = {{"version", version()}, {"compiler", compiler()}};
  return reply;
}

PageReply answer_signature(const nlohmann::json&, std::string_view) {
  PageReply reply;
  reply.answer = {{"signature", fmt::format("{:016x}", behaviour_signature())}};
  return reply;
}

}  // namespace labmouse
