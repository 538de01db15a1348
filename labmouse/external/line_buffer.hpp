// Bytes in, lines out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace labmouse {

/// What an external mouse wrote and nobody has read: lines end with LF, and every CR is dropped.
class LineBuffer {
 public:
  /// `longest`: bytes that a line may have.
  explicit LineBuffer(std::size_t longest) : longest_(longest) {}

  void append(std::string_view bytes) {
    // Lines that were taken go in one move, so that many short ones cost no more than their bytes.
    text_.erase(0, begin_);
    searched_ -= begin_;
    begin_ = 0;
    const std::size_t old = text_.size();
    text_ += bytes;
    // Hardly anyone writes one.
    if (const std::size_t first = text_.find('\r', old); first != std::string::npos)
      text_.erase(std::remove(text_.begin() + static_cast<std::ptrdiff_t>(first), text_.end(), '\r'), text_.end());
  }

  /// The next whole line without its end, valid until the next append; nothing where there is none or it is too long.
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

  /// What was not taken, whole lines or not.
  std::string_view rest() const { return std::string_view(text_).substr(begin_); }

 private:
  std::size_t longest_;
  std::string text_;
  std::size_t begin_ = 0;
  std::size_t searched_ = 0;  ///< no line ends before
  bool too_long_ = false;
};

}  // namespace labmouse
