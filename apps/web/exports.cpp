// The core of the page: labmouse as a WebAssembly module without loader code. The page calls labmouse_room() for
// memory, writes name, request (JSON) and bytes there, calls labmouse_call(), and reads the answer. labmouse/lab/page
// implements the calls, and native tests cover it.
#include <array>
#include <cstddef>
#include <string>

#include "labmouse/lab/page/calls.hpp"

#define LABMOUSE_EXPORT(name) extern "C" __attribute__((export_name(#name), used))

namespace {

/// The name, the request and its bytes.
std::array<std::string, 3> parts;
labmouse::PageAnswer answer;

}  // namespace

/// Allocates `size` bytes for a part of the call: 0 its name, 1 the request, 2 binary data.
LABMOUSE_EXPORT(labmouse_room) char* labmouse_room(std::size_t part, std::size_t size) {
  parts[part].resize(size);
  return parts[part].data();
}

/// Answers the call that was written to the parts.
LABMOUSE_EXPORT(labmouse_call) void labmouse_call() { answer = labmouse::answer_page(parts[0], parts[1], parts[2]); }

/// The answer to the last call: JSON and binary data. Valid until the next call.
LABMOUSE_EXPORT(labmouse_answer) const char* labmouse_answer() { return answer.json.data(); }
LABMOUSE_EXPORT(labmouse_answer_size) std::size_t labmouse_answer_size() { return answer.json.size(); }
LABMOUSE_EXPORT(labmouse_answer_bytes) const char* labmouse_answer_bytes() { return answer.bytes.data(); }
LABMOUSE_EXPORT(labmouse_answer_bytes_size) std::size_t labmouse_answer_bytes_size() { return answer.bytes.size(); }
