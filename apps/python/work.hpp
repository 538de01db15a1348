// Long work in a thread of its own, so that Python can show how far it is and hear Ctrl-C.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace labmouse::python {

class Work {
 public:
  Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  /// Stops it and waits for its end, without the interpreter's lock.
  ~Work();

  /// Once. What `body` throws is thrown again by finish().
  void start(std::function<void()> body);

  /// Waits so many seconds at most, without the interpreter's lock; whether it has ended.
  bool wait(double seconds);
  /// Waits for its end, without the interpreter's lock.
  void finish();

  /// From any thread: one contest of so many is done.
  void advance(std::size_t all);
  std::size_t done() const { return done_; }
  std::size_t all() const { return all_; }

  void stop() { stop_ = true; }
  const std::atomic<bool>& stopped() const { return stop_; }

 private:
  void join();

  std::atomic<bool> stop_{false};
  std::atomic<std::size_t> done_{0}, all_{0};
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::exception_ptr thrown_;
  std::thread thread_;
};

}  // namespace labmouse::python
