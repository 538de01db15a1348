#include "work.hpp"

#include <nanobind/nanobind.h>

#include <chrono>

namespace nb = nanobind;

namespace labmouse::python {

Work::~Work() {
  stop();
  join();
}

void Work::start(std::function<void()> body) {
  thread_ = std::thread([this, body = std::move(body)] {
    try {
      body();
    } catch (...) {
      thrown_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    ended_.notify_all();
  });
}

bool Work::wait(double seconds) {
  const nb::gil_scoped_release others;
  std::unique_lock lock(mutex_);
  return ended_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return has_ended_; });
}

void Work::finish() {
  join();
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Work::advance(std::size_t all) {
  all_ = all;
  ++done_;
}

void Work::join() {
  if (!thread_.joinable()) return;
  const nb::gil_scoped_release others;
  thread_.join();
}

}  // namespace labmouse::python
