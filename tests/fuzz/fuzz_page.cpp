// Any bytes as a call of the page: in the first line its name, in the second the request, and below what goes beside
// it. Whatever is asked, the answer is JSON, and either an answer or a failure.
#include <nlohmann/json.hpp>

#include "labmouse/lab/page/calls.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

/// Takes a line off the text.
std::string_view line_of(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

}  // namespace

LABMOUSE_FUZZER(page) {
  std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const std::string_view call = line_of(text), request = line_of(text);
  // These two measure for seconds, whatever is asked.
  if (call == "signature" || call == "speed") return 0;
  const nlohmann::json said = nlohmann::json::parse(answer_page(call, request, text).json, nullptr, false);
  require(said.is_object() && said.size() == 1 && said.contains("answer") != said.contains("failure"));
  if (said.contains("failure")) require(said["failure"]["error"].is_string() && said["failure"]["error"] != "");
  return 0;
}

}  // namespace labmouse::fuzz
