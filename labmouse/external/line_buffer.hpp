// Splits a stream of bytes into lines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace labmouse {

/// Unread output of an external mouse. Lines end with LF; every CR is dropped.
class LineBuffer {
 public:
  /// `longest`: largest number of bytes of a line.
  explicit LineBuffer(std::size_t longest) : longest_(longest) {}

  void append(std::string_view bytes) {
    // Removes all taken lines in one move, so that many short lines cost linear time.
    text_.erase(0, begin_);
    searched_ -= begin_;
    begin_ = 0;
    const std::size_t old = text_.size();
    text_ += bytes;
    // A CR is rare, so it is searched first.
    if (const std::size_t first = text_.find('\r', old); first != std::string::npos)
      text_.erase(std::remove(text_.begin() + static_cast<std::ptrdiff_t>(first), text_.end(), '\r'), text_.end());
  }

  /// The next complete line without its end, valid until the next append; nullopt if there is none or it is too long.
  std::optional<std::string_view> next() {
    const std::size_t end = text_.find('\n', searched_);
    searched_ = end == std::string::npos ? text_.size() : end;
    if (searched_ - begin_ > longest_) too_long_ = true;
    if (end == std::string::npos || too_long_) return std::nullopt;
    const std::string_view line = std::string_view(text_).substr(begin_, end - begin_);
    begin_ = searched_ = end + 1;
    return line;
  }

  /// Whether the line that next() would return is longer than allowed; it stays so.
  bool too_long() const { return too_long_; }

  /// All bytes not yet taken.
  std::string_view rest() const { return std::string_view(text_).substr(begin_); }

 private:
  std::size_t longest_;
  std::string text_;
  std::size_t begin_ = 0;
  std::size_t searched_ = 0;  ///< no line ends before this position
  bool too_long_ = false;
};

}  // namespace labmouse
