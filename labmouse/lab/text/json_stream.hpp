// Writes JSON piece by piece, exactly as the library prints the whole with an indent of one, but with only the largest
// value in memory. Invalid UTF-8 in names of files is replaced.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/text_sink.hpp"

namespace labmouse {

/// Writes one JSON value to a sink.
class JsonStream {
 public:
  explicit JsonStream(TextSink sink) : sink_(std::move(sink)) {}

  /// Inside an object each call needs a key of plain letters; inside a list none.
  void begin_object(std::string_view key = {}) { begin('{', '}', key); }
  void begin_list(std::string_view key = {}) { begin('[', ']', key); }
  void value(const Json& json, std::string_view key = {});
  /// Adds all fields of an object to the object that is open.
  void fields(const Json& object);
  /// Ends the innermost object or list.
  void end();
  /// Ends the text and flushes the rest to the sink.
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
