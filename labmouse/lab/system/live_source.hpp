// What sends bytes as time passes: serial ports and other terminals, connections over TCP, pipes and files.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "labmouse/lab/system/descriptor.hpp"

namespace labmouse {

/// Reads a source piece by piece.
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

 private:
  Descriptor descriptor_;
};

/// A source, or why it cannot be read: exactly one of the two is there.
struct OpenedSource {
  std::optional<LiveSource> source;
  std::string error;  ///< without the name of the source
};

/// Opens a source. A terminal, such as a serial port, is set to raw bytes at that speed; standard input is left as it
/// is. Waits up to five seconds for a connection.
/// @param name `-` for standard input, `tcp:HOST:PORT`, or a path.
/// @param baud the speed of a serial port, in bits per second.
OpenedSource open_source(const std::string& name, int baud);

}  // namespace labmouse
