// Text functions without allocation, for code between fork and exec.
#pragma once

#include <unistd.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace labmouse {

/// A path or line in a fixed buffer; longer text is cut.
class ShortText {
 public:
  ShortText& operator<<(std::string_view part) {
    for (const char letter : part)
      if (size_ + 1 < text_.size()) text_[size_++] = letter;
    return *this;
  }
  ShortText& operator<<(std::uint64_t number) {
    constexpr std::size_t most_digits = 20;
    std::array<char, most_digits> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return *this << std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data()));
  }

  const char* c_str() const { return text_.data(); }
  std::size_t size() const { return size_; }

 private:
  std::array<char, 4200> text_{};  ///< the longest path plus a prefix
  std::size_t size_ = 0;
};

/// Calls `take` with each positive whole number in a file of numbers.
template <class Take>
void for_each_number(int file, const Take& take) {
  std::array<char, 4096> text{};
  int number = 0;
  for (ssize_t size; (size = read(file, text.data(), text.size())) > 0;)
    for (ssize_t i = 0; i < size; ++i) {
      const char letter = text[static_cast<std::size_t>(i)];
      if (letter >= '0' && letter <= '9') {
        number = number * 10 + (letter - '0');
      } else {
        if (number > 0) take(number);
        number = 0;
      }
    }
}

}  // namespace labmouse
