// Records in a small form, for reports that carry thousands of them: what the mouse did, and nothing that playing it in
// its maze tells as well.
//
// Actions are one text. A step that is in every mouse's reach is a letter:
//
//   rotation   movement -3 -2 -1  0  1  2  3
//        -90             a  b  c  d  e  f  g
//          0             h  i  j  k  l  m  n
//         90             o  p  q  r  s  t  u
//
// Any other is (ROTATION,MOVEMENT), a reset is R, and a forfeit is !REASON; with the reason's name.
#pragma once

#include <optional>
#include <string>

#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// `mouse`, `maze` (its name), `seed` (as a text where it is above 2^53, which JavaScript would round), `actions` (a
/// text, about one character a step), `outcome` unless the record breaks off, the `world` where it is not that of the
/// capstone, the `rules` where they are not its, and `last_words` and `counts` where there are any. Reasons are left
/// out: a built-in mouse has them again when it is run again.
Json pack_record(const RecordFile& file);

/// A record, or why the JSON is none: exactly one of the two is there.
struct UnpackResult {
  std::optional<RecordFile> file;
  std::string error;
};

/// The record as it was packed, for its maze. Only the actions, the outcome, the last words and the counts are given:
/// `replay` fills in the rest, and tells where the record does not fit the maze. Never throws, whatever the JSON.
UnpackResult unpack_record(const ReadJson& json, const Maze& maze);

}  // namespace labmouse
