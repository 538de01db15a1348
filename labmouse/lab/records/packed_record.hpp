// Compact records, for reports that contain thousands of them: only the actions, from which a replay in the maze
// restores the rest.
//
// Actions are one text. A step that every mouse can make is a letter:
//
//   rotation   movement -3 -2 -1  0  1  2  3
//        -90             a  b  c  d  e  f  g
//          0             h  i  j  k  l  m  n
//         90             o  p  q  r  s  t  u
//
// Any other step is (ROTATION,MOVEMENT), a reset is R, and a forfeit is ! and the name of its reason.
#pragma once

#include <optional>
#include <string>

#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// An object of `mouse`, `maze` (its name), `seed` (a text above 2^53, which JavaScript would round), `actions` (a text
/// of about one character a step), `outcome` unless the record breaks off, `world` and `rules` where they are not the
/// default ones, and `last_words` and `counts` where there are any. Reasons are left out: running a built-in mouse
/// again restores them.
Json pack_record(const RecordFile& file);

/// A record, or what is wrong with the JSON: exactly one of the two is there.
struct UnpackResult {
  std::optional<RecordFile> file;
  std::string error;
};

/// Reads a packed record for its maze. It holds only the actions, the outcome, the last words and the counts; `replay`
/// restores the rest and reports whether it fits the maze. Never throws on any JSON.
UnpackResult unpack_record(const ReadJson& json, const Maze& maze);

}  // namespace labmouse
