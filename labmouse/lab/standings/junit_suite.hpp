// JUnit XML in pieces: test suites with their tests.
#pragma once

#include <span>
#include <string>
#include <utility>

namespace labmouse {

/// A test suite. Names and messages are escaped.
class JUnitSuite {
 public:
  explicit JUnitSuite(std::string name) : name_(std::move(name)) {}

  void pass(const std::string& test) { add(test, ""); }
  void skip(const std::string& test);
  void fail(const std::string& test, const std::string& message);

  /// The element.
  std::string text() const;

 private:
  /// `inside`: an element that says how the test ended; empty for a passed one.
  void add(const std::string& test, const std::string& inside);

  std::string name_, cases_;
  int tests_ = 0, failures_ = 0, skipped_ = 0;
};

/// The whole file.
std::string junit_text(std::span<const JUnitSuite> suites);

}  // namespace labmouse
