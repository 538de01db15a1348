// The core of the page: labmouse as a WebAssembly module without a loader. The page writes the name of a call, a
// request (JSON) and bytes beside it into room that the module gives it, calls, and reads the answer. What the calls
// mean is in labmouse/lab/page, where it is tested natively.
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

/// Room for that many bytes of a part: 0 the name of the call, 1 the request, 2 what goes beside it.
LABMOUSE_EXPORT(labmouse_room) char* labmouse_room(std::size_t part, std::size_t size) {
  parts[part].resize(size);
  return parts[part].data();
}

/// Answers the call whose parts are there.
LABMOUSE_EXPORT(labmouse_call) void labmouse_call() { answer = labmouse::answer_page(parts[0], parts[1], parts[2]); }

/// The answer to the last call: JSON, and what goes beside it.
LABMOUSE_EXPORT(labmouse_answer) const char* labmouse_answer() { return answer.json.data(); }
LABMOUSE_EXPORT(labmouse_answer_size) std::size_t labmouse_answer_size() { return answer.json.size(); }
LABMOUSE_EXPORT(labmouse_answer_bytes) const char* labmouse_answer_bytes() { return answer.bytes.data(); }
LABMOUSE_EXPORT(labmouse_answer_bytes_size) std::size_t labmouse_answer_bytes_size() { return answer.bytes.size(); }
