#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "labmouse/lab/drawing.hpp"
#include "tests/lab/drawing_samples.hpp"
#include "tests/lab/xml_scanner.hpp"

namespace labmouse {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

DrawingLayers all_layers() {
  DrawingLayers layers;
  layers.coordinates = true;
  layers.title = "Ring";
  layers.label = [](Cell cell) { return std::to_string(cell.x); };
  layers.label_meaning = "columns";
  layers.route = way_to_goal();
  layers.visits = [](Cell cell) { return cell.y; };
  layers.unknown = WallSet::all({3, 3});
  layers.mouse = Pose{{2, 2}, Heading::west};
  return layers;
}

/// The data of the path behind the place where `mark` stands.
std::string path_after(const std::string& svg, std::string_view mark) {
  const auto begin = svg.find(" d=\"", svg.find(mark)) + 4;
  return svg.substr(begin, svg.find('"', begin) - begin);
}

constexpr std::string_view walls = "class=\"stroke-ink\"";

TEST(SvgDrawing, IsWellFormedWithAllLayersAndWithNone) {
  for (const Size size : {Size{1, 1}, Size{3, 3}, Size{64, 1}, Size{64, 64}}) {
    const Maze maze = empty(size);
    EXPECT_EQ(XmlScanner(draw_svg(maze, {})).complaint(), "");
    DrawingLayers layers = all_layers();
    layers.route.resize(1);
    layers.mouse = Pose{};
    layers.unknown = WallSet::all(size);
    EXPECT_EQ(XmlScanner(draw_svg(maze, layers)).complaint(), "");
  }
  EXPECT_EQ(XmlScanner(draw_svg(ring(), all_layers())).complaint(), "");
}

TEST(SvgDrawing, ScannerSeesWhatIsWrong) {
  for (const std::string_view bad : {"<a>", "<a></b>", "<a b></a>", "<a b=\"&\"/>", "<a>\x01</a>", "<a/><a/>", "x<a/>"})
    EXPECT_NE(XmlScanner(bad).complaint(), "") << bad;
}

TEST(SvgDrawing, EscapesWhatComesFromOutside) {
  using namespace std::string_literals;
  const std::string hostile = "\"><script>alert('1')</script>&amp; \x01\x1b\x00\xff\xed\xa0\x80]]>"s;
  DrawingLayers layers = all_layers();
  layers.title = hostile;
  layers.label_meaning = hostile;
  layers.label = [&](Cell) { return hostile; };
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  EXPECT_THAT(svg, HasSubstr("&lt;script&gt;alert(&#39;1&#39;)"));
  EXPECT_THAT(svg, HasSubstr("&amp;amp;"));
  EXPECT_THAT(svg, Not(HasSubstr("\xff")));
}

TEST(SvgDrawing, WallsAreOnePathWithOneSegmentAWall) {
  const std::string svg = draw_svg(ring(), {});
  EXPECT_EQ(count(svg, walls), 1);
  EXPECT_EQ(count(path_after(svg, walls), "M"), 12 + 4);
}

TEST(SvgDrawing, UnknownWallsAreAPathOfTheirOwn) {
  DrawingLayers layers;
  layers.unknown = WallSet::all({3, 3});
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_EQ(count(path_after(svg, walls), "M"), 12);
  EXPECT_EQ(count(path_after(svg, "stroke-dasharray"), "M"), 12);
}

TEST(SvgDrawing, RouteHasADotForEachStep) {
  DrawingLayers layers;
  layers.route = way_to_goal();
  layers.route.push_back({{1, 1}, Heading::east});
  layers.route.push_back({{0, 0}, Heading::north});
  layers.route.push_back({{0, 1}, Heading::north});
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_EQ(count(svg, "class=\"stop\""), 6);
  EXPECT_THAT(svg, HasSubstr("<title>step 4: (1,1) east</title>"));
  EXPECT_THAT(svg, HasSubstr(">6 steps, 5 cells<"));
}

TEST(SvgDrawing, RouteLeavesTheMiddleOnlyWhereItComesAgain) {
  DrawingLayers layers;
  layers.route = {{{0, 0}, Heading::north}, {{0, 2}, Heading::north}};
  EXPECT_EQ(path_after(draw_svg(ring(), layers), "stroke-opacity"), "M40 120L40 40");
  layers.route.push_back({{0, 0}, Heading::north});  // backwards
  EXPECT_EQ(path_after(draw_svg(ring(), layers), "stroke-opacity"), "M46 120L46 40L34 40L34 120");
}

TEST(SvgDrawing, LegendNamesOnlyWhatIsShown) {
  const std::string bare = draw_svg(ring(), {});
  for (const auto* words : {">unknown wall<", ">mouse<", "visits to a cell<", ">columns<"}) {
    EXPECT_THAT(bare, Not(HasSubstr(words)));
    EXPECT_THAT(draw_svg(ring(), all_layers()), HasSubstr(words));
  }
}

TEST(SvgDrawing, SpeaksToThoseWhoDoNotSeeIt) {
  const std::string svg = draw_svg(ring(), all_layers());
  EXPECT_THAT(svg, HasSubstr("role=\"img\""));
  EXPECT_THAT(svg, HasSubstr("<title>Ring</title>"));
  EXPECT_THAT(svg, HasSubstr("<desc>A maze of 3 by 3 cells; start (0,0), 1 goal cell. Route: 3 steps, 4 cells."));
}

TEST(SvgDrawing, HasColoursForDarkGround) {
  EXPECT_THAT(draw_svg(ring(), {}), HasSubstr("@media (prefers-color-scheme:dark)"));
}

}  // namespace
}  // namespace labmouse
