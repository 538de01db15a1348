// The core of the page: labmouse as a WebAssembly module without a loader. The page writes a request (JSON, and bytes
// beside it) into room that the module gives it, calls one of the functions below, and reads the answer. What they mean
// is in labmouse/lab/page, where it is tested natively.
#include <cstddef>
#include <string>

#include "labmouse/lab/page/calls.hpp"

#define LABMOUSE_EXPORT(name) extern "C" __attribute__((export_name(#name), used))

namespace {

std::string request, request_bytes;
labmouse::PageAnswer answer;

void call(std::string_view name) { answer = labmouse::answer_page(name, request, request_bytes); }

char* room(std::string& text, std::size_t size) {
  text.resize(size);
  return text.data();
}

}  // namespace

/// Room for a request of that many bytes, and for what goes beside it.
LABMOUSE_EXPORT(labmouse_request) char* labmouse_request(std::size_t size) { return room(request, size); }
LABMOUSE_EXPORT(labmouse_request_bytes) char* labmouse_request_bytes(std::size_t size) {
  return room(request_bytes, size);
}

/// The answer to the last call: JSON, and what goes beside it.
LABMOUSE_EXPORT(labmouse_answer) const char* labmouse_answer() { return answer.json.data(); }
LABMOUSE_EXPORT(labmouse_answer_size) std::size_t labmouse_answer_size() { return answer.json.size(); }
LABMOUSE_EXPORT(labmouse_answer_bytes) const char* labmouse_answer_bytes() { return answer.bytes.data(); }
LABMOUSE_EXPORT(labmouse_answer_bytes_size) std::size_t labmouse_answer_bytes_size() { return answer.bytes.size(); }

LABMOUSE_EXPORT(labmouse_about) void labmouse_about() { call("about"); }
LABMOUSE_EXPORT(labmouse_signature) void labmouse_signature() { call("signature"); }
LABMOUSE_EXPORT(labmouse_speed) void labmouse_speed() { call("speed"); }
LABMOUSE_EXPORT(labmouse_builtin_maze) void labmouse_builtin_maze() { call("builtin_maze"); }
LABMOUSE_EXPORT(labmouse_make_maze) void labmouse_make_maze() { call("make_maze"); }
LABMOUSE_EXPORT(labmouse_open) void labmouse_open() { call("open"); }
LABMOUSE_EXPORT(labmouse_inspect) void labmouse_inspect() { call("inspect"); }
LABMOUSE_EXPORT(labmouse_write_maze) void labmouse_write_maze() { call("write_maze"); }
LABMOUSE_EXPORT(labmouse_link) void labmouse_link() { call("link"); }
LABMOUSE_EXPORT(labmouse_read_link) void labmouse_read_link() { call("read_link"); }
LABMOUSE_EXPORT(labmouse_run) void labmouse_run() { call("run"); }
LABMOUSE_EXPORT(labmouse_drive) void labmouse_drive() { call("drive"); }
LABMOUSE_EXPORT(labmouse_contest) void labmouse_contest() { call("contest"); }
LABMOUSE_EXPORT(labmouse_robot) void labmouse_robot() { call("robot"); }
LABMOUSE_EXPORT(labmouse_regions) void labmouse_regions() { call("regions"); }
LABMOUSE_EXPORT(labmouse_unpack) void labmouse_unpack() { call("unpack"); }
LABMOUSE_EXPORT(labmouse_race) void labmouse_race() { call("race"); }
LABMOUSE_EXPORT(labmouse_compare) void labmouse_compare() { call("compare"); }
LABMOUSE_EXPORT(labmouse_losses) void labmouse_losses() { call("losses"); }
LABMOUSE_EXPORT(labmouse_beliefs) void labmouse_beliefs() { call("beliefs"); }
LABMOUSE_EXPORT(labmouse_picture) void labmouse_picture() { call("picture"); }
LABMOUSE_EXPORT(labmouse_guest_begin) void labmouse_guest_begin() { call("guest_begin"); }
LABMOUSE_EXPORT(labmouse_guest_hear) void labmouse_guest_hear() { call("guest_hear"); }
LABMOUSE_EXPORT(labmouse_guest_end) void labmouse_guest_end() { call("guest_end"); }
