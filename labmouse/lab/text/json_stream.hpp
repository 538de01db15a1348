// JSON that is written while it is made: byte for byte what the library would print of the whole, indented by one, in
// the memory of its largest value. Names come from the file system and may be no UTF-8: what is none is replaced.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/text_sink.hpp"

namespace labmouse {

class JsonStream {
 public:
  explicit JsonStream(TextSink sink) : sink_(std::move(sink)) {}

  /// Within an object each of these takes a key, of plain letters; within a list none.
  void begin_object(std::string_view key = {}) { begin('{', '}', key); }
  void begin_list(std::string_view key = {}) { begin('[', ']', key); }
  void value(const Json& json, std::string_view key = {});
  /// All fields of an object, into the object that was begun last.
  void fields(const Json& object);
  /// Ends what was begun last.
  void end();
  /// Ends the text, and hands over what was not yet.
  void finish();

 private:
  struct Open {
    char closing;
    bool any = false;
  };

  void begin(char opening, char closing, std::string_view key);
  void lead(std::string_view key);
  void hand_over(std::size_t least);

  TextSink sink_;
  std::string text_;
  std::vector<Open> open_;
};

}  // namespace labmouse
