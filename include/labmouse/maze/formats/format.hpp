// Maze files: which formats there are, how one is recognised, read and written. docs/reference/maze-files.md has the
// grammars.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "labmouse/maze/formats/read_result.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// A maze as file content, or the reason why the format cannot hold it.
struct WriteResult {
  std::optional<std::string> content;
  std::string reason;
};

/// One file format; each is defined in a file of its own.
struct Format {
  std::string_view name;
  std::string_view summary;
  std::string_view extension;  ///< of the files that labmouse writes, such as ".num"
  /// Whether content seems to be of this format. Never fails, and can be wrong only for malformed content.
  /// @param content the bytes of a file, of any size and origin.
  bool (*recognises)(std::string_view content);
  /// Reads a maze of this format. Never throws.
  /// @param content the bytes of a file, of any size and origin.
  /// @return the maze, or what is wrong, with lines and columns.
  ReadResult (*read)(std::string_view content);
  /// Writes a maze in this format.
  /// @param maze any maze.
  /// @return the content of a file, or why the format cannot hold the maze.
  WriteResult (*write)(const Maze& maze);
};

extern const Format capstone_format;
extern const Format drawing_format;
extern const Format num_format;
extern const Format maz_format;
extern const Format hex_format;
extern const Format blocks_format;
extern const Format dump_format;
extern const Format csv_format;
extern const Format json_format;
extern const Format c_format;
extern const Format steps_format;

/// All formats, in the order in which they are tried.
std::span<const Format* const> all_formats();
/// The format of a name.
/// @param name exactly.
/// @return in static memory; null if there is none of that name.
const Format* find_format(std::string_view name);

/// The format that belongs to the extension of a file name. `.txt`, `.maze` and none are the drawing's.
/// @param name with or without folders.
/// @return in static memory; null if no format has the extension.
const Format* format_of_file(std::string_view name);
/// The first format that recognises the content.
/// @param content the bytes of a file, of any size and origin.
/// @return in static memory; null if no format does.
const Format* recognised_format(std::string_view content);

/// How to read a file that does not say enough, or contradicts itself.
struct ReadChoice {
  const Format* format = nullptr;  ///< null: the first that recognises the content
  bool transposed = false;         ///< x and y change places
  bool repaired = false;           ///< a wall stays where a cell contradicts its neighbour
  bool gaps_are_places = false;    ///< the two gaps in the border are the start and the goal
  bool closes_unseen = false;      ///< a partial map is a maze in which the unseen walls are closed
};

/// Reads a maze. Never throws.
/// @param content the bytes of the file, of any size and origin.
/// @param choice its format, if it is known, and what to do where the file does not say enough.
/// @return the maze, or what is wrong, with lines and columns.
ReadResult read_maze(std::string_view content, const ReadChoice& choice = {});

/// Writes a map as a drawing, with `...` and `:` for its unseen walls.
/// @param map `unseen` may be empty: then this is what drawing_format writes.
/// @return the content of a file, or why a drawing cannot hold the map: the start is a goal, or does not head north.
WriteResult write_partial_map(const PartialMap& map);

}  // namespace labmouse
