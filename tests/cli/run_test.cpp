// One contest in any world.
#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ARunner : public AUser {
 protected:
  ARunner() { file("m.txt", "o---o---o\n| G     |\no   o   o\n|   |   |\no   o---o\n| S |   |\no---o---o\n"); }

  Ended run_in(const std::string& world, std::vector<std::string> options = {}) const {
    const std::string mouse = world == "mms" ? "mms:\"" LABMOUSE_MMS_PROGRAM "\"" : "certify";
    options.insert(options.begin(), {"run", mouse, "m.txt", "--world", world});
    return labmouse(std::move(options));
  }
};

TEST_F(ARunner, HasAContestInEveryWorldAndItsRecord) {
  for (const char* world : {"steps", "seconds", "physical", "failures", "mms"}) {
    const Ended ran = run_in(world, {"--record", "r.jsonl", "--svg", "r.svg"});
    EXPECT_EQ(ran.code, 0) << world << ran.err;
    EXPECT_THAT(content("r.svg"), HasSubstr("<svg")) << world;
    const Ended replayed = labmouse({"replay", "r.jsonl"});
    EXPECT_EQ(replayed.code, 0) << world << replayed.err;
    // Below stands what a user has to know of a program.
    EXPECT_THAT(ran.out, StartsWith(replayed.out)) << world;
  }
}

TEST_F(ARunner, MeetsTheSameDiceWithTheSameSeedAlone) {
  const auto drawn = [&](const char* seed) { return run_in("physical", {"--noise", "4", "--seed", seed}).out; };
  EXPECT_EQ(drawn("1"), drawn("1"));
  EXPECT_NE(drawn("1"), drawn("2"));
}

TEST_F(ARunner, IsTheSameAsAContestOfARace) {
  const auto raced = nlohmann::json::parse(
      labmouse({"race", "--mice", "certify", "--mazes", "m.txt", "--world", "seconds", "--format", "json"}).out);
  ASSERT_EQ(run_in("seconds", {"--record", "r.jsonl"}).code, 0);
  const std::string text = content("r.jsonl");
  const auto last = nlohmann::json::parse(text.substr(text.rfind('\n', text.size() - 2) + 1));
  EXPECT_EQ(last["score"]["value"], raced["groups"][0]["mice"][0]["results"][0]["score"]["value"]);
}

TEST_F(ARunner, GoesWhereItsMouseCanGo) {
  EXPECT_EQ(labmouse({"run", "festina", "m.txt"}).out, labmouse({"run", "festina", "m.txt", "--world", "seconds"}).out);
  is_refused({"run", "wall-left", "m.txt", "--world", "seconds"}, "error: ", "'wall-left'", "seconds");
  is_refused({"run", "certify", "m.txt", "--noise", "2"}, "--noise", "--world physical");
  is_refused({"run", "certify", "m.txt", "--world", "physical", "--noise", "1,2"}, "several values");
}

TEST_F(ARunner, WatchesWhereverMiceDecide) {
  for (const char* world : {"steps", "seconds", "physical", "failures"}) {
    const std::string plain = run_in(world).out;
    const Ended watched = run_in(world, {"--watch"});
    EXPECT_EQ(watched.code, 0) << world << watched.err;
    EXPECT_THAT(watched.out, EndsWith(plain)) << world;
    EXPECT_GT(watched.out.size(), 2 * plain.size()) << world;
  }
}

}  // namespace
}  // namespace labmouse::test
