// Paths that name what cannot be replaced: standard input and output, pipes, devices.
#pragma once

#include <optional>
#include <string>

namespace labmouse {

/// The descriptor that a path names, if it is one that the program was started with: 0 for `-` and `/dev/stdin` where
/// it is read; N for `/dev/fd/N`, which is what a shell makes of `<(...)` and `>(...)`.
std::optional<int> descriptor_to_read(const std::string& path);

/// The same where it is written: 1 for `-` and `/dev/stdout`, 2 for `/dev/stderr`, N for `/dev/fd/N`.
std::optional<int> descriptor_to_write(const std::string& path);

/// Whether what is written there is gone: into a descriptor, a pipe or a device. A file can be written again and holds
/// the last text only.
bool is_stream(const std::string& path);

}  // namespace labmouse
