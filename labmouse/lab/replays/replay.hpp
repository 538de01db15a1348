// A contest read from its record and played again in its maze, whatever its world: what is shown of it, and what
// reports take.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// Which contest a record is of.
struct RecordSubject {
  std::string mouse;
  NamedMaze maze;
  std::optional<std::uint64_t> seed;  ///< nothing where records have none
};

/// The world in which a contest was run, and its conditions there: an object as WorldTraits::conditions has them.
struct RecordedWorld {
  std::string name;
  Json conditions;
};

/// A maze with chosen layers of a record.
struct RecordDrawing {
  Maze maze;
  DrawingLayers layers;
  std::string line;  ///< the record in one line with its end, for below the drawing
  std::map<Layer, std::string>
      missing;        ///< layers that were chosen and of which the record has nothing: "no speed run"
  std::string error;  ///< why there is no drawing; otherwise empty
};

/// A record that was played again and agrees with its maze.
class Replay {
 public:
  virtual ~Replay() = default;

  virtual RecordSubject subject() const = 0;
  /// The whole record, as a file.
  virtual std::string text() const = 0;
  /// The record in the form that reports carry.
  virtual Json packed() const = 0;
  /// The world in which other mice can run the same contest; nothing if they cannot.
  virtual std::optional<RecordedWorld> world() const = 0;
  /// Frame by frame: `Play` in apps/web/page/src/core/types.ts.
  virtual Json play() const = 0;

  /// One self-contained SVG picture.
  virtual std::string picture() const = 0;
  /// A drawing or a table, and how the contest went, in lines for a terminal.
  virtual std::string summary(const TextDrawer& draw) const = 0;
  /// The result and its score in one line with its end.
  virtual std::string result() const = 0;
  /// Why the mouse did what it did, with so many candidates of each choice at most, or what happened to it, in lines.
  /// Empty where the record has no reasons.
  virtual std::string reasons(int candidates) const = 0;
  /// Draws the mouse after each of its moves, and calls `show` with each drawing.
  virtual void animate(const TextDrawer& draw, const std::function<void(const std::string&)>& show) const = 0;

  /// The layers from which drawing() may be asked to choose; empty where all drawings are the same.
  virtual const LayerSet& layers() const = 0;
  /// The contest after so many steps, or the whole one after 0.
  virtual RecordDrawing drawing(const LayerSet& chosen, int step) const = 0;

  /// Runs the contest again with the mouse of the record to get the reasons of its decisions. They are kept only if all
  /// steps are the same.
  virtual void add_reasons(const Contestant& mouse) = 0;
};

/// A replay, or what is wrong with a text: problems where it is no record, a disagreement where the contest could not
/// have happened in its maze.
struct OpenedRecord {
  std::unique_ptr<Replay> replay;
  std::vector<Problem> problems;
  std::string disagreement;
  bool lacks_maze = false;  ///< the text is a record, but it has no maze, and none was given
};

/// Records of one kind; several worlds may have it.
struct RecordKind {
  std::string_view header;  ///< value of the key `labmouse` in its first line
  std::string_view name;    ///< "a record in steps"
  std::string_view packed;  ///< the member of Replay::packed() that no other kind has
  /// Plays the record in `maze` instead of its own where that is not null.
  OpenedRecord (*open)(std::string_view text, const NamedMaze* maze);
  /// Opens the packed record from a report, of a contest in that maze.
  OpenedRecord (*unpack)(const ReadJson& packed, const NamedMaze& maze);
};

/// Puts a record into another maze, where there is one.
template <class File>
void put_into(const NamedMaze* maze, File& file) {
  if (maze == nullptr) return;
  file.maze = maze->maze;
  file.maze_name = maze->name;
}

/// Shows the record in seconds of a contest that this program has just run, without a check. Null if it is none.
std::unique_ptr<Replay> fresh_drive_replay(std::string_view text);

extern const RecordKind steps_records, drive_records, mms_records;

}  // namespace labmouse
