// Paths of streams: standard input and output, pipes and devices. A stream cannot be replaced by a rename.
#pragma once

#include <optional>
#include <string>

namespace labmouse {

/// The descriptor that a path for reading names: 0 for `-` and `/dev/stdin`; N for `/dev/fd/N`, which a shell makes of
/// `<(...)` and `>(...)`. Nothing for other paths.
std::optional<int> descriptor_to_read(const std::string& path);

/// The same for a path for writing: 1 for `-` and `/dev/stdout`, 2 for `/dev/stderr`, N for `/dev/fd/N`.
std::optional<int> descriptor_to_write(const std::string& path);

/// Whether a path is a descriptor, a pipe or a device. A text written there cannot be replaced by a later one, unlike
/// in a file.
bool is_stream(const std::string& path);

}  // namespace labmouse
