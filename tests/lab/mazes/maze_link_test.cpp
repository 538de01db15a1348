#include "labmouse/lab/mazes/maze_link.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/maze/random_maze.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.";

std::string error_of(const std::string& link) {
  const ReadLinkResult read = read_link(link);
  EXPECT_EQ(read.maze.has_value(), read.error.empty()) << link;
  return read.error;
}

RC_GTEST_PROP(MazeLink, HoldsEveryMazeUnderAnyName, ()) {
  const Maze maze = *test::marked_mazes();
  const auto name = *rc::gen::arbitrary<std::string>();
  const std::string link = link_of({name, maze});
  RC_ASSERT(link.find_first_not_of(letters) == std::string::npos);
  const ReadLinkResult read = read_link(link);
  RC_ASSERT(read.error.empty());
  RC_ASSERT(read.maze->maze == maze);
  RC_ASSERT(read.maze->name == name);
}

RC_GTEST_PROP(MazeLink, TakesNoOtherText, (const std::string& text)) {
  RC_ASSERT(!read_link(text).error.empty());
  RC_ASSERT(!read_link("1." + text).error.empty());
}

TEST(MazeLink, StaysAsItIs) {
  // North sides 1110 and six open east sides are 111000 000000. Links that people have kept must be read for ever.
  EXPECT_EQ(link_of(test::corridor()), "1.4x2.ABn.AA.4A.corridor.-hhrkD");
}

TEST(MazeLink, OfAContestMazeIsShort) {
  for (const BuiltinMaze& builtin : builtin_mazes()) {
    const NamedMaze maze{std::string(builtin.name), *read_maze(builtin.text).maze};
    const int area = maze.maze.size().area();
    EXPECT_LE(link_of(maze).size(), static_cast<std::size_t>(area) / 3 + 45) << maze.name;
    EXPECT_EQ(read_link(link_of(maze)).maze->maze, maze.maze);
  }
}

TEST(MazeLink, ThatIsCutSaysSoWhereverItIsCut) {
  const std::string link = link_of(test::loop());
  EXPECT_THAT(error_of(""), HasSubstr("empty"));
  for (std::size_t length = 1; length < link.size(); ++length)
    EXPECT_THAT(error_of(link.substr(0, length)), HasSubstr("incomplete")) << length;
  EXPECT_THAT(error_of(link.substr(0, link.size() - 1)), HasSubstr("checksum"));
  EXPECT_THAT(error_of(link.substr(0, 4)), HasSubstr("size"));
}

TEST(MazeLink, WithOneOtherCharacterIsRefused) {
  const std::string link = link_of({"of/two words.txt", test::hook().maze});
  for (std::size_t i = 0; i < link.size(); ++i)
    for (int other = 0; other < 256; ++other) {
      std::string changed = link;
      changed[i] = static_cast<char>(other);
      EXPECT_EQ(error_of(changed).empty(), changed == link) << i << ": " << changed;
    }
}

TEST(MazeLink, SaysWhatItIsInPlaceOfALink) {
  const std::string link = link_of(test::loop());
  EXPECT_THAT(error_of("2" + link.substr(1)), Says("version 2", "version 1"));
  EXPECT_THAT(error_of("https://example.org"), HasSubstr("not a link"));
  EXPECT_THAT(error_of("."), HasSubstr("not a link"));
  EXPECT_THAT(error_of(link + "A"), Says("damaged", "after its checksum"));
  std::string other = link;
  std::swap(other[14], other[15]);
  EXPECT_THAT(error_of(other), Says("damaged", "checksum does not match"));
}

/// The link with another part and the checksum that belongs to it.
std::string forged(std::string_view start, std::string_view goals = "c", std::string_view walls = "A",
                   std::string_view name = "x", std::string_view size = "2x2") {
  std::string text = "1.";
  for (const auto part : {size, start, goals, walls, name}) text += std::string(part) + ".";
  std::uint32_t hash = 0x811C9DC5U;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x01000193U;
  for (int i = 0; i < 6; ++i, hash >>= 6U) text += letters[hash & 63U];
  return text;
}

TEST(MazeLink, IsRefusedWhereItIsRightButNoMaze) {
  EXPECT_EQ(error_of(forged("AAn")), "");
  EXPECT_EQ(error_of(forged("BBw", "AA", "8", "")), "");
  const auto refused = [](const std::string& link) { EXPECT_THAT(error_of(link), HasSubstr("valid maze")) << link; };
  for (const char* size : {"", "2", "2x", "x2", "02x2", "2x2x", "2x2 ", "-2x2", "0x2", "65x2", "2X2", "99999999999x2"})
    refused(forged("AAn", "c", "A", "x", size));
  for (const char* start : {"", "AA", "AAu", "CAn", "ACn", "AAnn", "A n"}) refused(forged(start));
  for (const char* goals : {"", "A", "C", "CA", "AAA", "AAAA", "BAAA", "AABAABBB"}) refused(forged("AAn", goals));
  for (const char* walls : {"", "AA", "B", "*"}) refused(forged("AAn", "c", walls));
  for (const char* name : {"_", "_4", "_4g", "_2f", "_41", "/", "\xff"}) refused(forged("AAn", "c", "A", name));
  refused(forged("AAn", "c", "A", std::string(longest_link_name + 1, 'x')));
}

TEST(MazeLink, KeepsTheEndOfALongName) {
  const std::string file = std::string(longest_link_name - 1, 'x');
  EXPECT_EQ(read_link(link_of({"a/folder/" + file, test::hook().maze})).maze->name, "/" + file);
  // No half of a character stands at its beginning.
  EXPECT_EQ(read_link(link_of({"folder\xE2\x82\xAC" + file, test::hook().maze})).maze->name, file);
}

}  // namespace
}  // namespace labmouse
