#include "labmouse/lab/text/json_stream.hpp"

#include <algorithm>

namespace labmouse {
namespace {

constexpr int indent = 1;

std::string dumped(const Json& json) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); }

}  // namespace

void JsonStream::value(const Json& json, std::string_view key) {
  lead(key);
  // Line breaks in this text come from indenting: inside strings they are written as `\n`.
  const std::string text = dumped(json);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    text_.append(text, begin, end - begin);
    if (text[end - 1] == '\n') text_.append(open_.size() * indent, ' ');
    begin = end;
  }
  constexpr std::size_t part = std::size_t{1} << 16U;
  hand_over(part);
}

void JsonStream::fields(const Json& object) {
  for (const auto& field : object.items()) value(field.value(), field.key());
}

void JsonStream::end() {
  const Open ended = open_.back();
  open_.pop_back();
  if (ended.any) text_.append("\n").append(open_.size() * indent, ' ');
  text_ += ended.closing;
}

void JsonStream::finish() {
  text_ += '\n';
  hand_over(1);
}

void JsonStream::begin(char opening, char closing, std::string_view key) {
  lead(key);
  text_ += opening;
  open_.push_back({closing});
}

/// Writes the text before a value: a comma after another value, the indent and the key.
void JsonStream::lead(std::string_view key) {
  if (open_.empty()) return;
  text_ += open_.back().any ? ",\n" : "\n";
  open_.back().any = true;
  text_.append(open_.size() * indent, ' ');
  if (!key.empty()) text_.append(dumped(key)).append(": ");
}

void JsonStream::hand_over(std::size_t least) {
  if (text_.size() < least) return;
  sink_(text_);
  text_.clear();
}

}  // namespace labmouse
