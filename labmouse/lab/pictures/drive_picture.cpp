#include "labmouse/lab/pictures/drive_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/drawing/scene.hpp"
#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/lab/pictures/path_data.hpp"
#include "labmouse/lab/pictures/trace_path.hpp"
#include "labmouse/lab/system/file_names.hpp"

namespace labmouse {
namespace {

using namespace drawing;

constexpr int coordinates_room = 12;  // pixels

/// From slow to fast: a part of "plasma" (Smith and van der Walt 2015), whose lightness increases monotonically, so
/// that it is readable without colour vision.
constexpr std::array<Tone, 7> speed_tones = {{
    {"speed1", "#0d0887", "#6f7bff"},
    {"speed2", "#5302a3", "#9b6dff"},
    {"speed3", "#8b0aa5", "#c863de"},
    {"speed4", "#b83289", "#e072ae"},
    {"speed5", "#db5c68", "#f08b7c"},
    {"speed6", "#f48849", "#f9aa58"},
    {"speed7", "#f0a91e", "#fdd64f"},
}};

constexpr Tone belief_tone = {"belief", "#0b7285", "#66d9e8"};
constexpr Tone touch_tone = {"touch", "#c92a2a", "#ff8787"};

using Path = std::vector<DrivePathPoint>;

/// Maps the range of speeds of a path to the tones, in equal parts.
class SpeedScale {
 public:
  explicit SpeedScale(const Path& path) {
    if (path.empty()) return;
    const auto [slow, fast] =
        std::minmax_element(path.begin(), path.end(), [](const auto& a, const auto& b) { return a.speed < b.speed; });
    low_ = slow->speed;
    high_ = fast->speed;
  }
  std::size_t level(double speed) const {
    if (high_ <= low_) return speed_tones.size() - 1;
    const double share = (speed - low_) / (high_ - low_);
    return std::min(static_cast<std::size_t>(share * static_cast<double>(speed_tones.size())), speed_tones.size() - 1);
  }
  std::string words() const { return fmt::format("{:.2f} to {:.2f} m/s", low_ / 1e3, high_ / 1e3); }

 private:
  double low_ = 0.0, high_ = 0.0;
};

std::string curve_svg(const Tone& tone, double width, const std::string& data) {
  return fmt::format("<path {} stroke-width=\"{:.1f}\" stroke-linejoin=\"round\" stroke-linecap=\"round\" d=\"{}\"/>\n",
                     stroke(tone), width, data);
}

/// A line for each stretch of one level. The level of a piece is that of its mean speed.
std::string coloured(const Frame& frame, const Path& path, const SpeedScale& scale) {
  std::string svg;
  const auto level = [&](std::size_t i) { return scale.level((path[i].speed + path[i + 1].speed) / 2.0); };
  for (std::size_t first = 0; first + 1 < path.size();) {
    std::size_t last = first + 1;
    while (last + 1 < path.size() && level(last) == level(first)) ++last;
    svg += curve_svg(speed_tones[level(first)], 4.0, data_through(frame, path, first, last));
    first = last;
  }
  return svg;
}

std::string dashed_svg(const std::string& data) {
  return fmt::format("<path {} stroke-width=\"1.2\" stroke-dasharray=\"3 3\" d=\"{}\"/>\n", stroke(belief_tone), data);
}

std::string cross_at(double x, double y) {
  return fmt::format("<path {} stroke-width=\"2\" d=\"M{:.1f} {:.1f}l8 8m0 -8l-8 8\"/>\n", stroke(touch_tone), x - 4,
                     y - 4);
}
std::string cross_svg(const Frame& frame, const DrivePathPoint& at) {
  return cross_at(frame.origin.x + at.x * Frame::cell, frame.origin.y + (frame.size.height - at.y) * Frame::cell);
}

std::string ramp() {
  std::string svg;
  for (std::size_t i = 0; i < speed_tones.size(); ++i)
    svg += fmt::format("<path {} stroke-width=\"6\" d=\"M{} 0h10\"/>", stroke(speed_tones[i]), 10 * i);
  return svg;
}

std::vector<Tone> tones() {
  std::vector<Tone> all(speed_tones.begin(), speed_tones.end());
  all.insert(all.end(), {belief_tone, touch_tone});
  return all;
}

/// Content of a picture: a speed run over thin lines of searches, estimated paths, and touches.
struct Drives {
  Path fast;
  std::vector<Path> searches;
  std::vector<Path> beliefs;
  std::vector<DrivePathPoint> touches;
  std::string title;
  std::string description;
};

std::string picture(const Maze& maze, const Drives& drives) {
  DrawingLayers layers;
  layers.coordinates = true;
  const Scene scene = {maze,
                       layers,
                       Frame{maze.size(), {sheet_margin + coordinates_room, sheet_margin + 32}},
                       Heat(maze.size(), nullptr),
                       {}};
  const SpeedScale scale(drives.fast);
  const int width = std::max(scene.frame.right() + sheet_margin, least_sheet_width);
  Legend legend({scene.frame.origin.x, scene.frame.bottom() + 24 + sheet_margin}, width - sheet_margin);
  std::string lines;
  for (const Path& search : drives.searches)
    if (search.size() > 1) lines += curve_svg(muted, 1.5, data_through(scene.frame, search, 0, search.size() - 1));
  for (const Path& belief : drives.beliefs)
    if (belief.size() > 1) lines += dashed_svg(data_through(scene.frame, belief, 0, belief.size() - 1));
  for (const DrivePathPoint& touch : drives.touches) lines += cross_svg(scene.frame, touch);
  if (!drives.beliefs.empty()) legend.add(24, dashed_svg("M0 0h24"), "where it believed to be");
  if (!drives.touches.empty()) legend.add(12, cross_at(6, 0), "touched a wall");
  if (!drives.searches.empty())
    legend.add(24, fmt::format("<path {} stroke-width=\"1.5\" d=\"M0 0h24\"/>", stroke(muted)), "searching");
  if (drives.fast.size() > 1) legend.add(70, ramp(), scale.words());
  const Sheet sheet = {width, legend.bottom() + sheet_margin / 2, drives.title, drives.description, tones()};
  return sheet.with(heading_svg({scene.frame.origin.x, sheet_margin + 14}, width - sheet_margin, drives.title) +
                    floor_svg(scene) + lines + coloured(scene.frame, drives.fast, scale) + walls_svg(scene) +
                    labels_svg(scene) + coordinates_svg(scene) + legend.svg());
}

/// Index of the run drawn in colours; the number of runs if there is none.
std::size_t coloured_run(const DriveRecordFile& file) {
  const DriveScore result = score(file.record, file.rules);
  const auto& runs = file.record.runs;
  const auto fast = [&](std::size_t i) { return runs[i].has_route(); };
  if (result.best && fast(result.runs[*result.best].run)) return result.runs[*result.best].run;
  for (std::size_t i = runs.size(); i-- > 0;)
    if (fast(i)) return i;
  return runs.size();
}

}  // namespace

std::string draw_route(const Maze& maze, const DriveRoute& driven, const DriveModel& model, const std::string& title) {
  Drives drives;
  drives.fast = path_of(driven, 0, model);
  drives.title = title;
  drives.description =
      fmt::format("A route of {} pieces that takes {:.3f} s.", driven.segments.size(), driven.time / 1e6);
  return picture(maze, drives);
}

std::string draw_contest(const DriveRecordFile& file) {
  Drives drives;
  const std::size_t best = coloured_run(file);
  DrivePath path({file.maze->start(), file.maze->start_heading()}, *file.model);
  if (file.physical) {
    for (std::size_t i = 0; i < file.record.runs.size(); ++i)
      if (Path belief = believed_path(file, i); !belief.empty()) drives.beliefs.push_back(std::move(belief));
    for (const WallTouch& touch : file.physical->notes.touches) drives.touches.push_back(touched_at(file, touch));
  }
  for (std::size_t i = 0; i < file.record.runs.size(); ++i) {
    const DriveRun& run = file.record.runs[i];
    Path points = has_trace(file) ? true_path(file, i) : path.follow(run, pace_of(file, run));
    if (i == best)
      drives.fast = std::move(points);
    else if (!run.has_route())
      drives.searches.push_back(std::move(points));
  }
  const DriveScore result = score(file.record, file.rules);
  drives.title =
      fmt::format("{} in {}: {}", file.mouse, stem_of(file.maze_name),
                  result.best ? value_text(*result.value(), file.rules) : std::string(name_of(file.record.outcome)));
  drives.description = result_line(file);
  return picture(*file.maze, drives);
}

}  // namespace labmouse
