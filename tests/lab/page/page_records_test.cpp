// Packed records, pictures, beliefs, comparisons, links and files, as the page asks for them.
#include <gmock/gmock.h>

#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/numbers/verdict.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/records/packed_record.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/mouse/distance.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/lab/records/mms_record_fixture.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::failure;
using test::json;
using test::recorded;
using test::Says;
using ::testing::HasSubstr;

json of_maze(const NamedMaze& maze, const json& more = json::object()) {
  json request = {{"maze", data_of(maze)}};
  request.update(more);
  return request;
}

json packed(std::string_view spec) { return json::parse(pack_record(recorded(spec)).dump()); }

TEST(PageUnpacks, WhatRunningTheMouseGives) {
  for (const char* spec : {"ariadne", "flood:stride=1", "random"}) {
    const json ran = answer("contest", of_maze(test::loop(), {{"mouse", spec}, {"seed", 1}}));
    const json unpacked = answer("unpack", of_maze(test::loop(), {{"record", packed(spec)}}));
    EXPECT_EQ(unpacked["play"], ran["play"]) << spec;
  }
}

TEST(PageUnpacks, WithoutReasonsWhatTheMouseWouldNotDo) {
  json record = packed("flood");
  for (const char* mouse : {"ariadne", "festina", "program:./mine", "no mouse"}) {
    record["mouse"] = mouse;
    EXPECT_EQ(answer("unpack", of_maze(test::loop(), {{"record", record}}))["play"]["reasons"], json::array()) << mouse;
  }
}

TEST(PageUnpacks, NoRecordThatIsNoneOrOfAnotherMaze) {
  const json said = failure("unpack", of_maze(test::loop(), {{"record", 3}}));
  EXPECT_THAT(said["error"].get<std::string>(), Says("report", "record"));
  EXPECT_EQ(said["problems"].size(), 1U);
  EXPECT_THAT(error_of("unpack", of_maze(test::corridor(), {{"record", packed("flood")}})),
              Says("flood in corridor", "match its maze"));
  EXPECT_THAT(error_of("unpack", of_maze(test::corridor())), Says("'record'", "missing"));
}

TEST(PageUnpacks, RecordsOfMmsAsTheyAreOpened) {
  const std::string text = test::mms_recorded({"setColor 0 0 G", "moveForward"});
  const json unpacked =
      answer("unpack", of_maze(test::loop(), {{"record", {{"mouse", "m"}, {"maze", "z"}, {"mms", text}}}}));
  EXPECT_EQ(unpacked["play"], answer("open", {{"name", "r"}}, text)["play"]);
  EXPECT_EQ(unpacked["record"], text);
  const json cut = failure("unpack", of_maze(test::loop(), {{"record", {{"mms", text.substr(0, 20)}}}}));
  EXPECT_THAT(cut["error"].get<std::string>(), Says("report", "record of mms"));
  EXPECT_EQ(cut["problems"][0]["line"], 1);
}

TEST(PagePicture, IsOfAMazeOrOfARecord) {
  EXPECT_THAT(answer("picture", of_maze(test::loop()))["svg"].get<std::string>(), HasSubstr("<svg"));
  const RecordFile file = recorded("flood");
  EXPECT_EQ(answer("picture", json::object(), write_record(file))["svg"], picture_of(file));
  EXPECT_THAT(error_of("picture", json::object(), "{}"), HasSubstr("not a readable record"));
  EXPECT_THAT(error_of("picture", json::object()), Says("'maze'", "missing"));
}

/// The distances in `bytes`, frame after frame.
std::vector<int> numbers(const std::string& bytes) {
  std::vector<int> list;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
    list.push_back(static_cast<unsigned char>(bytes[i]) + 256 * static_cast<unsigned char>(bytes[i + 1]));
  return list;
}

/// The corridor: from (0,1) east, down and back west to (0,0). Its wall in the middle is seen piece by piece.
TEST(PageBeliefs, AreDistancesOverWallsNotYetSeen) {
  const json known = json::parse("[1,2,-1,0, 0,0,0,0,  0,0,0,0, 0,0,0,0]");
  const json request = of_maze(test::corridor(), {{"known", known}, {"frames", 4}, {"stride", 3}});
  const PageAnswer said = answer_page("beliefs", request.dump(), "");
  EXPECT_EQ(json::parse(said.json), json::parse(R"({"answer":{}})"));
  const std::vector<int> open = {0, 1, 1, 1, 1, 2, 2, 2}, once = {0, 1, 1, 1, 3, 2, 2, 2},
                         twice = {0, 1, 1, 1, 3, 3, 2, 2};
  std::vector<int> all = open;
  for (const auto* frame : {&once, &twice, &twice}) all.insert(all.end(), frame->begin(), frame->end());
  EXPECT_EQ(numbers(said.bytes), all);
}

TEST(PageBeliefs, AreTheTruthOfWhoKnowsAll) {
  const json request = of_maze(test::without_route(), {{"known", {0, 0, 0, 0}}, {"frames", 1}, {"stride", 3}});
  EXPECT_EQ(numbers(answer_page("beliefs", request.dump(), "").bytes), (std::vector<int>{65535, 0}));
}

TEST(PageBeliefs, AreNotOfWrongLists) {
  const auto error = [](const json& more) { return error_of("beliefs", of_maze(test::hook(), more)); };
  const json zeros = {0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_THAT(error({{"known", {1}}, {"frames", 2}, {"stride", 3}}), Says("'known'", "1 walls", "8"));
  EXPECT_THAT(error({{"known", {0, 0, 0, 0, 0, 0, 2, 0}}, {"frames", 2}, {"stride", 3}}), Says("'known'", "-1 to 1"));
  EXPECT_THAT(error({{"known", zeros}, {"frames", 0}, {"stride", 3}}), Says("'frames'", " 1 to "));
  EXPECT_THAT(error({{"known", zeros}, {"frames", 2}, {"stride", 9}}), Says("'stride'", "1 to 8"));
  EXPECT_THAT(error({{"known", zeros}, {"frames", 2000000000}, {"stride", 3}}), Says("2000000000 frames", "too many"));
}

TEST(PageCompares, AsTheLabDoes) {
  const std::vector<double> differences = {-1, 0.5, -2, 0, -8, -3, -1.5, -2.5};
  const PairedDifference found = paired_difference(differences, 1);
  const json said = answer("compare", {{"differences", differences}});
  EXPECT_EQ(said, (json{{"count", 8},
                        {"mean", found.mean},
                        {"interval", {found.interval.low, found.interval.high}},
                        {"below", 6},
                        {"equal", 1},
                        {"above", 1},
                        {"sign_test", found.sign_test},
                        {"p", found.p},
                        {"verdict", name_of(verdict_of(found, found.p))}}));
  const Interval other = paired_difference(differences, 7).interval;
  EXPECT_EQ(answer("compare", {{"differences", differences}, {"seed", 7}})["interval"], json({other.low, other.high}));
  EXPECT_NE(other, found.interval);
  EXPECT_EQ(answer("compare", {{"differences", json::array()}})["count"], 0);
  EXPECT_THAT(error_of("compare", {{"differences", {1, nullptr}}}), Says("'differences'", "number"));
}

TEST(PageLinks, HoldMazes) {
  const std::string link = answer("link", of_maze(test::loop()))["link"];
  EXPECT_EQ(link, link_of(test::loop()));
  EXPECT_EQ(answer("read_link", {{"link", link}})["maze"], data_of(test::loop()));
  const json said = failure("read_link", {{"link", link.substr(0, link.size() - 3)}});
  EXPECT_THAT(said["error"].get<std::string>(), Says("link", "not contain a maze"));
  EXPECT_EQ(said["problems"].size(), 1U);
}

TEST(PageWrites, MazesInEveryFormat) {
  const NamedMaze maze = {"dir/my maze.txt", test::hook().maze.with_goals(centre_of({2, 2}))};
  for (const Format* format : all_formats()) {
    if (format->name == "maz") continue;
    const json said = answer("write_maze", of_maze(maze, {{"format", format->name}}));
    EXPECT_EQ(said["text"], *format->write(maze.maze).content);
    EXPECT_EQ(said["file_name"], "my_maze" + std::string(format->extension));
  }
}

TEST(PageWrites, BytesOfTheBinaryFormat) {
  const Maze maze(MazeDraft({16, 16}, MazeDraft::Inside::open));
  const json said = answer("write_maze", of_maze({"m", maze}, {{"format", "maz"}}));
  EXPECT_EQ(said["file_name"], "m.maz");
  const std::vector<unsigned char> bytes = said["bytes"];
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), *maz_format.write(maze).content);
}

TEST(PageWrites, NothingThatAFormatCannotHold) {
  EXPECT_THAT(error_of("write_maze", of_maze(test::hook(), {{"format", "maz"}})), Says("maz ", "goal"));
  EXPECT_THAT(error_of("write_maze", of_maze(test::hook(), {{"format", "png"}})), Says("unknown format", "'png'"));
}

}  // namespace
}  // namespace labmouse
