// What a mouse draws: it is seen on the canvas and nowhere else.
#include "tests/external/mms_fixture.hpp"

namespace labmouse::test {
namespace {

/// One line, and what is drawn in one cell afterwards: the walls by their letters, the colour, the text.
struct Stroke {
  const char* name;
  const char* lines;
  Cell cell;
  const char* drawing;
  int invalid = 0;
};

void PrintTo(const Stroke& stroke, std::ostream* out) { *out << stroke.lines; }

std::string drawn_in(const MmsCanvas& canvas, Cell cell) {
  std::string words;
  for (const Heading side : all_headings)
    if (canvas.has_wall(cell, side)) words += name_of(side)[0];
  if (canvas.colour(cell) != 0) words += std::string(" colour ") + canvas.colour(cell);
  if (!canvas.text(cell).empty()) words += " '" + std::string(canvas.text(cell)) + "'";
  return words;
}

class MmsDrawing : public testing::TestWithParam<Stroke> {};

TEST_P(MmsDrawing, IsOnTheCanvas) {
  MmsHost host(plank(), {});
  EXPECT_EQ(told(host, std::string(GetParam().lines) + "\n"), "");
  EXPECT_EQ(drawn_in(host.canvas(), GetParam().cell), GetParam().drawing);
  EXPECT_EQ(host.invalid_lines(), GetParam().invalid);
}

constexpr Stroke strokes[] = {
    {"WallToTheNorth", "setWall 1 0 n", {1, 0}, "n"},
    {"WallToTheEast", "setWall 1 0 e", {1, 0}, "e"},
    {"WallToTheSouth", "setWall 1 1 s", {1, 1}, "s"},
    {"WallToTheWest", "setWall 1 1 w", {1, 1}, "w"},
    {"WallHasTwoSides", "setWall 1 0 n\nsetWall 0 1 e", {1, 1}, "sw"},
    {"WallOnTheBorder", "setWall 0 0 s\nsetWall 0 0 w", {0, 0}, "sw"},
    {"WallOnTheFarBorder", "setWall 2 1 n\nsetWall 2 1 e", {2, 1}, "ne"},
    {"WallGoes", "setWall 1 0 n\nsetWall 1 0 e\nclearWall 1 0 n", {1, 0}, "e"},
    {"WallGoesFromTheOtherSide", "setWall 1 0 n\nclearWall 1 1 s", {1, 0}, ""},
    {"WallThatIsNotThereGoes", "clearWall 1 0 n", {1, 0}, ""},
    {"WallTwiceIsOneWall", "setWall 1 0 n\nsetWall 1 0 n\nclearWall 1 0 n", {1, 0}, ""},
    {"WallOutsideIsIgnored", "setWall 3 0 w\nsetWall 0 2 s\nsetWall -1 0 e\nsetWall 0 -1 n", {0, 0}, ""},
    {"WallFarOutsideIsIgnored", "setWall 256 0 n\nsetWall 65536 0 n\nsetWall 0 -256 n", {0, 0}, ""},
    {"WallBesideTheMazeIsNoneInside", "setWall 3 0 w", {2, 0}, ""},
    {"ClearWallOutsideIsIgnored", "setWall 2 0 e\nclearWall 3 0 w", {2, 0}, "e"},
    {"WallNeedsALowerCaseLetter", "setWall 1 0 N", {1, 0}, "", 1},
    {"WallNeedsOneLetter", "setWall 1 0 north", {1, 0}, "", 1},
    {"WallNeedsALetterOfFour", "setWall 1 0 q", {1, 0}, "", 1},
    {"WallNeedsASide", "setWall 1 0", {1, 0}, "", 1},
    {"WallTakesNoMore", "setWall 1 0 n n", {1, 0}, "", 1},
    {"WallNeedsWholeNumbers", "setWall 1.0 0 n\nsetWall 1 x n", {1, 0}, "", 2},
    {"WallNeedsNumbersOf32Bits", "setWall 4294967297 0 n", {1, 0}, "", 1},
    {"WallMayHaveBlanks", "  setWall  1  0  n  ", {1, 0}, "n"},
    {"ClearWallNeedsAGoodForm", "setWall 1 0 n\nclearWall 1 0\nclearWall 1 0 x\nclearWall a 0 n", {1, 0}, "n", 3},
    {"WallsWithMoreLettersAreNone", "setWalls 1 0 n\nclearWalls 1 0 n", {1, 0}, "", 2},

    {"Colour", "setColor 1 1 r", {1, 1}, " colour r"},
    {"ColourIsPaintedOver", "setColor 1 1 r\nsetColor 1 1 G", {1, 1}, " colour G"},
    {"ColourDarkOrange", "setColor 1 1 O", {1, 1}, " colour O"},
    {"ColourDarkViolet", "setColor 1 1 V", {1, 1}, " colour V"},
    {"ColourGoes", "setColor 1 1 r\nclearColor 1 1", {1, 1}, ""},
    {"ColourOfOthersStays", "setColor 1 1 r\nclearColor 1 0", {1, 1}, " colour r"},
    {"ColoursAllGo", "setColor 1 1 r\nsetText 1 1 a\nclearAllColor", {1, 1}, " 'a'"},
    {"ColourOutsideIsIgnored", "setColor 3 1 r\nsetColor 1 2 r\nclearColor 9 9", {1, 1}, ""},
    {"ColourNeedsALetterItKnows", "setColor 1 1 o\nsetColor 1 1 x\nsetColor 1 1 W", {1, 1}, " colour o", 2},
    {"ColourVioletIsDarkOnly", "setColor 1 1 v", {1, 1}, "", 1},
    {"ColourNeedsOneLetter", "setColor 1 1 red", {1, 1}, "", 1},
    {"ColourNeedsALetter", "setColor 1 1", {1, 1}, "", 1},
    {"ColourNeedsWholeNumbers", "setColor a b r", {0, 0}, "", 1},
    {"ClearColorTakesACell", "setColor 1 1 r\nclearColor 1\nclearColor 1 1 r\nclearColor a 1", {1, 1}, " colour r", 3},
    {"ClearAllColorTakesNothing", "setColor 1 1 r\nclearAllColor 1", {1, 1}, " colour r", 1},
    {"ClearAllColorWithMoreLettersIsNone", "setColor 1 1 r\nclearAllColorX", {1, 1}, " colour r", 1},

    {"Text", "setText 1 0 abc", {1, 0}, " 'abc'"},
    {"TextIsWrittenOver", "setText 1 0 abcdef\nsetText 1 0 xy", {1, 0}, " 'xy'"},
    {"TextKeepsItsBlanks", "setText 1 0  a  b ", {1, 0}, " ' a  b '"},
    {"TextIsCutAfterTwoRows", "setText 1 0 0123456789abc", {1, 0}, " '0123456789'"},
    {"TextShowsAllOfAscii", "setText 1 0 !~#\"'%;|", {1, 0}, " '!~#\"'%;|'"},
    {"TextShowsABackslashAsAQuestion", "setText 1 0 a\\b", {1, 0}, " 'a?b'"},
    {"TextShowsATabAsAQuestion", "setText 1 0 a\tb\x7f", {1, 0}, " 'a?b?'"},
    {"TextShowsOtherLettersAsOneQuestionEach", "setText 1 0 \xC3\xA9\xE2\x82\xAC\xF0\x9F\x90\xAD.", {1, 0}, " '???.'"},
    {"TextShowsBrokenLettersAsQuestions", "setText 1 0 \xFF\x80\xC3.", {1, 0}, " '???.'"},
    {"TextCutsAfterTenLettersNotBytes",
     "setText 1 0 \xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9Zz",
     {1, 0},
     " '?????????Z'"},
    {"TextMayBeEmpty", "setText 1 0 abc\nsetText 1 0 ", {1, 0}, ""},
    {"TextWithoutAThirdBlankIsTheLine", "setText 1 0", {1, 0}, " 'setText 1 '"},
    {"TextGoes", "setText 1 0 abc\nclearText 1 0", {1, 0}, ""},
    {"TextOfOthersStays", "setText 1 0 abc\nclearText 1 1", {1, 0}, " 'abc'"},
    {"TextsAllGo", "setText 1 0 abc\nsetColor 1 0 r\nclearAllText", {1, 0}, " colour r"},
    {"TextOutsideIsIgnored", "setText 3 0 a\nsetText 1 2 a\nsetText -1 0 a\nclearText 5 5", {1, 0}, ""},
    {"TextNeedsACell", "setText\nsetText 1\nsetText 1 ", {1, 0}, "", 3},
    {"TextNeedsWholeNumbers", "setText a 0 x\nsetText 1 b x", {1, 0}, "", 2},
    {"TextNeedsOneBlankBeforeX", "setText  1 0 abc", {1, 0}, "", 1},
    {"TextNeedsOneBlankBeforeY", "setText 1  0 abc", {1, 0}, "", 1},
    {"TextNeedsItsNameFirst", " setText 1 0 abc", {1, 0}, "", 1},
    {"ClearTextTakesACell", "setText 1 0 a\nclearText 1\nclearText 1 0 a\nclearText 1 b", {1, 0}, " 'a'", 3},
    {"ClearAllTextTakesNothing", "setText 1 0 a\nclearAllText 1", {1, 0}, " 'a'", 1},
    {"TextWithMoreLettersIsNone", "setTexts 1 0 abc\nclearTexts 1 0\nclearAllTextX", {1, 0}, "", 3},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsDrawing, testing::ValuesIn(strokes),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(MmsDrawing, KnowsSeventeenColours) {
  MmsHost host(plank(), {});
  for (const char letter : std::string_view("kbacgorwyBCAGORVY")) {
    told(host, std::string("setColor 0 0 ") + letter + "\n");
    EXPECT_EQ(host.canvas().colour({0, 0}), letter);
  }
  EXPECT_EQ(host.invalid_lines(), 0);
}

TEST(MmsDrawing, NeverChangesTheMaze) {
  MmsHost host(field(), {});
  EXPECT_EQ(
      told(host, "setWall 0 0 n\nwallFront\nclearWall 0 0 w\nwallLeft\nsetColor 0 1 r\nsetText 0 1 x\nmoveForward\n"),
      "false true ack");
  EXPECT_EQ(host.statistics().total_distance, 2);
}

TEST(MmsDrawing, StartsEmpty) {
  const MmsCanvas canvas(plank().size());
  for (int i = 0; i < 6; ++i) EXPECT_EQ(drawn_in(canvas, plank().size().cell_at(i)), "");
  EXPECT_EQ(MmsHost(plank(), {}).canvas(), canvas);
}

}  // namespace
}  // namespace labmouse::test
