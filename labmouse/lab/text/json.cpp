#include "labmouse/lab/text/json.hpp"

namespace labmouse {

bool is_too_deep(std::string_view text) {
  constexpr int most = 32;  // a race's JSON is 7 deep
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size() && depth <= most; ++i) {
    const char letter = text[i];
    if (quoted && letter == '\\') ++i;
    if (letter == '"') quoted = !quoted;
    if (quoted) continue;
    if (letter == '[' || letter == '{') ++depth;
    if (letter == ']' || letter == '}') --depth;
  }
  return depth > most;
}

ReadJson read_json(std::string_view text) {
  return is_too_deep(text) ? ReadJson(ReadJson::value_t::discarded) : ReadJson::parse(text, nullptr, false);
}

Json read_ordered_json(std::string_view text) {
  return is_too_deep(text) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

}  // namespace labmouse
