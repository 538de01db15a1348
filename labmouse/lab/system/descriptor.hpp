// A file descriptor that closes itself.
#pragma once

#include <cerrno>
#include <utility>

#include "labmouse/lab/system/calls.hpp"

namespace labmouse {

/// Closes the descriptor in its destructor, unless it is borrowed.
class Descriptor {
 public:
  static Descriptor opened(int number) { return {number, true}; }
  static Descriptor borrowed(int number) { return {number, false}; }

  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)), owned_(other.owned_) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&& other) noexcept {
    close();
    number_ = std::exchange(other.number_, -1);
    owned_ = other.owned_;
    return *this;
  }
  ~Descriptor() { close(); }

  /// The descriptor; -1 where it could not be opened.
  int number() const { return number_; }

  /// Closes it now. Returns an error number, because some systems report failed writes only then; 0 on success.
  int close() {
    const int number = std::exchange(number_, -1);
    return number >= 0 && owned_ && close_descriptor(number) != 0 ? errno : 0;
  }

 private:
  Descriptor(int number, bool owned) : number_(number), owned_(owned) {}

  int number_;
  bool owned_;
};

}  // namespace labmouse
