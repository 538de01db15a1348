#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "labmouse/lab/drawing/drawing.hpp"
#include "tests/lab/drawing/drawing_samples.hpp"
#include "tests/lab/xml_scanner.hpp"

namespace labmouse {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Three candidates of step 12: a chosen wall, one that is not worth it, and the goal.
StepReasons choice() {
  Reasons reasons;
  reasons.candidates = {{{{1, 1}, Heading::east}, {1, 1}, false, 523, 2, true, 604},
                        {{{0, 0}, Heading::north}, {0, 0}, false, 1000, 2, false, 1060},
                        {{}, {1, 1}, true, 300, 1, true, 700}};
  reasons.chosen = 0;
  reasons.way_here = 0.5;
  return {12, reasons};
}

DrawingLayers all_layers() {
  DrawingLayers layers;
  layers.coordinates = true;
  layers.title = "Ring";
  layers.label = [](Cell cell) { return std::to_string(cell.x); };
  layers.label_meaning = "columns";
  layers.route = way_to_goal();
  layers.visits = [](Cell cell) { return cell.y; };
  layers.unknown = WallSet::all({3, 3});
  layers.wrong = WallSet::all({3, 3});
  layers.search_run = search_run();
  layers.explored = explored();
  layers.candidates = choice();
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
    layers.wrong = WallSet::all(size);
    layers.explored = ExploredCells{CellSet::all(size), {}, CellSet::all(size)};
    layers.search_run = SearchLegs{{Pose{}}, {Pose{}}};
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

TEST(SvgDrawing, WrongGuessesAreAPathOfTheirOwn) {
  DrawingLayers layers;
  layers.unknown = WallSet::all({3, 3});
  layers.wrong = WallSet::all({3, 3});
  *layers.wrong -= ring().open_walls();
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_EQ(count(path_after(svg, "class=\"stroke-wrong\""), "M"), 4);
  EXPECT_EQ(count(path_after(svg, "stroke-dasharray"), "M"), 12 - 4);
  EXPECT_THAT(svg, HasSubstr(">4 wrong guesses: closed, never seen<"));
}

TEST(SvgDrawing, MissedAndFalseWallsOfAMapArePathsOfTheirOwn) {
  DrawingLayers layers;
  layers.wrong = WallSet::all({3, 3});
  *layers.wrong -= ring().open_walls();
  layers.false_walls = ring().open_walls();
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_EQ(count(path_after(svg, "class=\"stroke-wrong\""), "M"), layers.wrong->count());
  EXPECT_EQ(count(path_after(svg, "class=\"stroke-to-goal\""), "M"), layers.false_walls->count());
  EXPECT_THAT(svg, Not(HasSubstr("wrong guess")));
}

TEST(SvgDrawing, ExplorationIsALineToTheGoalAndOneFromThere) {
  DrawingLayers layers;
  layers.search_run = search_run();
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_EQ(path_after(svg, "class=\"stroke-to-goal\""), "M49 120L49 49L71 49L71 80");
  EXPECT_EQ(path_after(svg, "class=\"stroke-onwards\""), "M80 93L107 93L107 107L80 107");
  EXPECT_THAT(svg, HasSubstr(">3 steps to the goal<"));
  EXPECT_THAT(svg, HasSubstr(">3 steps from there on<"));
}

TEST(SvgDrawing, ExplorationWithoutAGoalIsOneLine) {
  DrawingLayers layers;
  layers.search_run = SearchLegs{{{{0, 0}, Heading::north}, {{0, 1}, Heading::north}}, {}};
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_THAT(svg, HasSubstr(">1 step, no goal entered<"));
  EXPECT_THAT(svg, Not(HasSubstr("class=\"stroke-onwards\"")));
}

TEST(SvgDrawing, ExploredCellsHaveTwoTonesAndTheirShares) {
  DrawingLayers layers;
  layers.explored = explored();
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_EQ(count(path_after(svg, "class=\"fill-visited\""), "M"), 6);
  EXPECT_EQ(count(path_after(svg, "class=\"fill-discovered\""), "M"), 2);
  EXPECT_THAT(svg, HasSubstr(">6 of 9 cells visited (66.7 %)<"));
  EXPECT_THAT(svg, HasSubstr(">8 of 9 cells discovered (88.9 %)<"));
}

TEST(SvgDrawing, HeatLeavesARimOfTheExploredCells) {
  DrawingLayers layers;
  layers.visits = [](Cell cell) { return cell == Cell{1, 1} ? 1 : 0; };
  EXPECT_EQ(path_after(draw_svg(ring(), layers), "class=\"fill-heat1\""), "M60 60h40v40h-40z");
  layers.explored = explored();
  EXPECT_EQ(path_after(draw_svg(ring(), layers), "class=\"fill-heat1\""), "M65 65h30v30h-30z");
}

TEST(SvgDrawing, CandidatesAreDashesWithTheirRunsAndTheChosenOneALine) {
  DrawingLayers layers;
  layers.candidates = choice();
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_THAT(svg, HasSubstr("stroke-width=\"7\" d=\"M100 60v40\"/>"));
  EXPECT_THAT(svg, HasSubstr("stroke-width=\"4\" stroke-dasharray=\"6 4\" stroke-opacity=\"0.5\" d=\"M20 100h40\"/>"));
  EXPECT_THAT(svg, HasSubstr("stroke-width=\"4\" stroke-dasharray=\"6 4\" d=\"M65 65h30v30h-30z\"/>"));
  EXPECT_THAT(svg,
              HasSubstr("<text x=\"100\" y=\"83\" font-weight=\"700\">17.4</text><text x=\"40\" y=\"103\">33.3</text>"
                        "<text x=\"80\" y=\"98\">5.0</text>"));
  EXPECT_THAT(svg, HasSubstr(">3 candidates of step 12, with ways ahead in steps<"));
  EXPECT_THAT(svg, HasSubstr(">chosen: 17.4<"));
}

TEST(SvgDrawing, CandidatesOfWhichNoneWasChosenSaySo) {
  DrawingLayers layers;
  layers.candidates = choice();
  layers.candidates->reasons.chosen = -1;
  layers.candidates->reasons.way_here = 1;
  const std::string svg = draw_svg(ring(), layers);
  EXPECT_THAT(svg, HasSubstr(">3 candidates of step 12, with runs in steps<"));
  EXPECT_THAT(svg, HasSubstr(">none chosen<"));
  EXPECT_THAT(svg, HasSubstr(" 3 candidates of step 12, with runs in steps; none chosen.</desc>"));
  EXPECT_THAT(svg, Not(HasSubstr("font-weight=\"700\"")));
}

TEST(SvgDrawing, DarkGroundHasRulesForEveryColourOfALayer) {
  const std::string bare = draw_svg(ring(), {});
  const std::string full = draw_svg(ring(), all_layers());
  for (const auto* rule : {".stroke-to-goal{", ".stroke-onwards{", ".stroke-wrong{", ".fill-visited{",
                           ".fill-discovered{", ".stroke-candidate{"}) {
    EXPECT_THAT(full, HasSubstr(rule));
    EXPECT_THAT(bare, Not(HasSubstr(rule)));
  }
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
  for (const auto* words : {">unknown wall<", ">mouse<", "visits to a cell<", ">columns<", "visited (", "discovered (",
                            "steps to the goal<", "wrong guesses: ", "candidates of step"}) {
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

/// The heading of a picture of the ring, which has room for 26 letters, with this title.
std::string heading(const std::string& title) {
  DrawingLayers layers;
  layers.title = title;
  const std::string svg = draw_svg(ring(), layers);
  const auto begin = svg.find('>', svg.find("<text")) + 1;
  return svg.substr(begin, svg.find('<', begin) - begin);
}

TEST(SvgDrawing, ATitleLosesItsFrontBeforeItsOutcome) {
  EXPECT_EQ(heading("mouse: out of steps"), "mouse: out of steps");
  EXPECT_EQ(heading("mouse-of-mine in a maze: at noon: out of steps"), "mouse-of-mi…: out of steps");
  EXPECT_EQ(heading("mouse: quite a very long outcome"), "quite a very long outcome");
  EXPECT_EQ(heading("mouse: an outcome that has no room at all"), "an outcome that has no ro…");
  EXPECT_EQ(heading("a title that has no colon in it"), "a title that has no colon…");
}

TEST(SvgDrawing, HasColoursForDarkGround) {
  EXPECT_THAT(draw_svg(ring(), {}), HasSubstr("@media (prefers-color-scheme:dark)"));
}

}  // namespace
}  // namespace labmouse
