// Runs long work in a thread of its own, so that Python can show progress and handle Ctrl-C.
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
  /// Asks the work to stop and waits for its end, with the GIL released.
  ~Work();

  /// Starts the work; call once. finish() rethrows what `body` throws.
  void start(std::function<void()> body);

  /// Waits at most `seconds`, with the GIL released. Returns whether the work has ended.
  bool wait(double seconds);
  /// Waits for the end of the work, with the GIL released.
  void finish();

  /// Counts one more contest of `all` as done. Thread-safe.
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
