// The maze as a mouse of mms meets it: sizes, start, walls.
#include "tests/external/mms_fixture.hpp"

namespace labmouse::test {
namespace {

class MmsWorld : public testing::TestWithParam<Rule> {};
TEST_P(MmsWorld, IsAsItSays) { expect(GetParam()); }

constexpr Rule world[] = {
    {"WidthIsWidth", plank, "mazeWidth", "3"},
    {"HeightIsHeight", plank, "mazeHeight", "2"},
    {"OneCellIsAMaze", box, "mazeWidth\nmazeHeight", "1 1"},
    {"StartIsTheCentreOfTheCornerNorthwards", field, "mazeWidth", "16", "(1,1) north"},
    {"StartHeadsNorthIntoAWallToo", box, "wallFront", "true", "(1,1) north"},
    {"NothingLeavesTheMaze", plank,
     "moveForward 9\nturnRight\nmoveForward 9\nturnRight\nmoveForward 9\nturnRight\nmoveForward 9",
     "crash ack crash ack crash ack crash", "(1,1) west"},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsWorld, testing::ValuesIn(world), name_of_rule);

TEST(MmsWorld, StartsInTheCornerWhateverTheMazeMarks) {
  const Maze maze = field().with_start({3, 4}, Heading::south);
  EXPECT_EQ(words_of(MmsHost(maze, {}).pose()), "(1,1) north");
}

class MmsWalls : public testing::TestWithParam<Rule> {};
TEST_P(MmsWalls, AreSeen) { expect(GetParam()); }

constexpr Rule walls[] = {
    {"InFront", field, "wallFront", "false"},
    {"AtTheRight", corner, "wallRight", "true"},
    {"AtTheBack", field, "wallBack", "true"},
    {"AtTheLeft", field, "wallLeft", "true"},
    {"TurnWithTheMouse", field, "turnRight\nwallFront\nwallRight\nwallBack\nwallLeft", "ack false true true false"},
    {"ToTheSouth", field, "turnRight\nturnRight\nwallFront\nwallRight\nwallBack\nwallLeft",
     "ack ack true true false false"},
    {"ToTheWest", field, "turnLeft\nwallFront\nwallRight\nwallBack\nwallLeft", "ack true false false true"},
    {"FromACentreEveryDiagonalIsAPost", field,
     "moveForward 3\nturnRight\nmoveForward 3\nwallFrontRight\nwallBackRight\nwallBackLeft\nwallFrontLeft",
     "ack ack ack true true true true"},
    {"FromACentreADiagonalHeadingSeesPosts", field,
     "moveForward 3\nturnRight45\nwallFront\nwallRight\nwallBack\nwallLeft", "ack ack true true true true"},
    {"FromACentreADiagonalHeadingSeesWallsBesideIt", field,
     "turnRight45\nwallFrontLeft\nwallFrontRight\nwallBackRight\nwallBackLeft", "ack false false true true"},
    {"OnAWallAlongItIsAPost", field, "moveForwardHalf\nwallLeft\nwallRight", "ack true true"},
    {"OnAWallAcrossItIsFree", field, "moveForwardHalf\nwallFront\nwallBack", "ack false false"},
    {"OnAnUprightWallAlongItIsAPost", field, "turnRight\nmoveForwardHalf\nwallLeft\nwallRight\nwallFront\nwallBack",
     "ack ack true true false false"},
    {"OnAWallADiagonalLeadsToTheNextWall", field,
     "moveForwardHalf\nwallFrontRight\nwallBackRight\nwallBackLeft\nwallFrontLeft", "ack false false true true"},
    {"OnAWallADiagonalIsBlockedByAWall", corner,
     "moveForwardHalf\nwallFrontRight\nwallBackRight\nwallBackLeft\nwallFrontLeft", "ack true true true true"},
    {"OnAWallADiagonalHeadingLooksAhead", field,
     "moveForwardHalf\nturnRight45\nwallFront\nwallRight\nwallBack\nwallLeft", "ack ack false false true true"},
    {"FrontRightIs45Degrees", corner, "moveForwardHalf 3\nwallFrontRight\nwallBackRight\nwallFrontLeft\nwallBackLeft",
     "ack false true true true"},
    {"BackRightIs135Degrees", corner,
     "moveForward 2\nturnRight\nturnRight\nmoveForwardHalf\nwallBackRight\nwallBackLeft", "ack ack ack ack true false"},
    {"OfNothingIsOneHalfStep", corner, "wallFront\nwallFront 1", "false false"},
    {"OneAndTwoAreTheSameFromACentre", corner, "moveForward\nwallFront 1\nwallFront 2\nwallRight 1\nwallRight 2",
     "ack false false true true"},
    {"ThreeLooksOneCellFurther", corner, "moveForward\nwallFront 2\nwallFront 3", "ack false true"},
    {"FarAheadAreCountedInHalfSteps", field, "wallFront 30\nwallFront 31", "false true"},
    {"NearerThanAskedCountAsWell", corner, "wallRight 3\nwallRight 4\nwallFront 6", "true true true"},
    {"BeyondTheBorderIsNothingToSee", field, "wallFront 2147483647\nwallBack 2147483647", "true true"},
    {"ToTheRightFarAway", field, "wallRight 30\nwallRight 31", "false true"},
    {"AtTheBackFarAway", field, "moveForward 5\nwallBack 10\nwallBack 11", "ack false true"},
    {"AtTheLeftFarAway", field, "turnRight\nmoveForward\nturnLeft\nwallLeft 2\nwallLeft 3", "ack ack ack false true"},
    {"OnTheDiagonalFarAway", field, "moveForwardHalf\nwallFrontRight 29\nwallFrontRight 30", "ack false true"},
    {"OnTheDiagonalOfACornerInHalfSteps", corner, "moveForwardHalf 3\nwallFrontRight 1\nwallFrontRight 2",
     "ack false true"},
    {"ZeroIsOneHalfStep", corner, "wallFront 0\nwallRight 0", "false true"},
    {"NegativeIsOneHalfStep", corner, "wallFront -5\nwallRight -5", "false true"},
    {"NoNumberIsOneHalfStep", corner, "wallFront abc\nwallRight abc\nwallFront 1.5\nwallFront 99999999999",
     "false true false false"},
    {"LookingMovesNothing", field, "wallFront 3\nwallLeft\ngetStat total-distance\ngetStat total-turns",
     "false true 0 0", "(1,1) north"},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsWalls, testing::ValuesIn(walls), name_of_rule);

TEST(MmsGoals, AreTheCentreOfEverySize) {
  EXPECT_EQ(mms_goals({16, 16}).count(), 4);
  EXPECT_TRUE(mms_goals({16, 16}).contains({7, 7}) && mms_goals({16, 16}).contains({8, 8}));
  EXPECT_EQ(mms_goals({5, 4}).count(), 2);
  EXPECT_TRUE(mms_goals({5, 4}).contains({2, 1}) && mms_goals({5, 4}).contains({2, 2}));
  EXPECT_EQ(mms_goals({3, 3}), CellSet::of({1, 1}));
  EXPECT_EQ(mms_goals({1, 1}), CellSet::of({0, 0}));
  EXPECT_EQ(mms_goals({1, 2}).count(), 2);
}

TEST(MmsPlaces, BelongToACell) {
  EXPECT_EQ(cell_of({1, 1}), (Cell{0, 0}));
  EXPECT_EQ(cell_of({2, 1}), (Cell{1, 0}));  // on a wall: the cell to its east
  EXPECT_EQ(cell_of({1, 2}), (Cell{0, 1}));  // or north
  EXPECT_EQ(cell_of({31, 30}), (Cell{15, 15}));
}

TEST(Compass, HasTheNamesOfEightDirections) {
  std::string names;
  for (int eighths = 0; eighths < 8; ++eighths) names += std::string(name_of(turned(Compass::north, eighths))) + " ";
  EXPECT_EQ(names, "north north-east east south-east south south-west west north-west ");
  EXPECT_EQ(turned(Compass::north, -3), Compass::south_west);
}

}  // namespace
}  // namespace labmouse::test
