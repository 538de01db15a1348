// What sends bytes as time passes: serial ports and other terminals, connections over TCP, pipes and files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "labmouse/lab/system/descriptor.hpp"

namespace labmouse {

/// Reads a source piece by piece, and answers.
class LiveSource {
 public:
  /// What came of waiting.
  struct Piece {
    std::string bytes;   ///< empty if nothing came
    bool ended = false;  ///< nothing more will come: the end of a file, a closed connection, an unplugged port
    std::string error;   ///< why it cannot be read; then it has ended, too
  };

  explicit LiveSource(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}

  /// Waits for bytes.
  /// @param milliseconds the longest time.
  Piece read(int milliseconds);

  /// Sends bytes to the robot, during the next calls of read(), because a robot may be slow to take them. Drops them
  /// while too much of what was sent before waits.
  void send(std::string_view bytes);

 private:
  Descriptor descriptor_;
  std::string waiting_;  ///< to be sent
};

/// A source, or why it cannot be read: exactly one of the two is there.
struct OpenedSource {
  std::optional<LiveSource> source;
  std::string error;  ///< without the name of the source
};

/// Whether a source is only read, or also answered.
enum class LiveUse : std::uint8_t { read, read_and_answer };

/// Opens a source. A terminal, such as a serial port, is set to raw bytes at that speed; standard input is left as it
/// is. Waits up to five seconds for a connection.
/// @param name `-` for standard input, `tcp:HOST:PORT`, or a path.
/// @param baud the speed of a serial port, in bits per second.
/// @param use what is neither a terminal nor a connection cannot be answered, which is an error.
OpenedSource open_source(const std::string& name, int baud, LiveUse use = LiveUse::read);

}  // namespace labmouse
