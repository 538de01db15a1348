// The reasons of a mouse in a record.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::changed;
using test::problem;
using test::read;
using test::recorded;
using test::Says;
using ::testing::HasSubstr;

/// Candidates with numbers of every kind, the goal the chosen one.
Reasons some_reasons() {
  Reasons reasons;
  reasons.candidates = {{{{1, 2}, Heading::north}, {1, 1}, false, 523, 2, true, 604.14453125},
                        {{{3, 0}, Heading::east}, {4, 0}, false, 2147483647, 0, false, -0.00390625},
                        {{}, {2, 2}, true, 0, 7, true, 210}};
  reasons.chosen = 2;
  reasons.known = 510;
  reasons.way_here = 0.5;
  reasons.hope = 523;
  reasons.price = 3.1328125;
  return reasons;
}

TEST(RecordedReasons, AreReadAsTheyWereWritten) {
  RecordFile file = recorded("flood");
  file.run.reasons = {{1, some_reasons()}, {3, Reasons()}};
  const std::string text = write_record(file);
  EXPECT_EQ(read(text).run, file.run);
  EXPECT_THAT(text, HasSubstr(R"({"wall":[3,0,"east"],"seen_from":[4,0],"through":2147483647,"travel":0,"worth":false,)"
                              R"("score":-0.00390625})"));
  EXPECT_THAT(text, HasSubstr(R"({"goal":true,"seen_from":[2,2],"through":0,"travel":7,"score":210.0}],)"
                              R"("chosen":2,"known":510,"way_here":0.5,"hope":523.0,"price":3.1328125}})"));
}

TEST(RecordedReasons, SayTheirGroundWhereItIsNotTheCandidates) {
  RecordFile file = recorded("flood");
  Reasons flood, no_loops;
  flood.ground = Ground::flood;
  no_loops.ground = Ground::no_loops;
  file.run.reasons = {{1, flood}, {2, some_reasons()}, {3, no_loops}};
  const std::string text = write_record(file);
  EXPECT_EQ(read(text).run, file.run);
  EXPECT_THAT(text, HasSubstr(R"("ground":"no loops")"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr(R"("ground":"candidates")")));
}

TEST(RecordedReasons, OfAMouseAreReadAsTheyWereWritten) {
  const RecordFile file = recorded("ariadne", test::loop(), 1, true);
  ASSERT_FALSE(file.run.reasons.empty());
  EXPECT_EQ(read(write_record(file)).run, file.run);
}

TEST(RecordedReasons, AreKeptInAReplay) {
  const RecordFile file = read(write_record(recorded("ariadne", test::loop(), 1, true)));
  EXPECT_EQ(replay(file, *file.maze).run, file.run);
}

TEST(RecordedReasons, AreNotMentionedWhereThereAreNone) {
  EXPECT_EQ(write_record(recorded("ariadne")).find("reasons"), std::string::npos);
  EXPECT_TRUE(read(write_record(recorded("ariadne"))).run.reasons.empty());
}

/// A record whose second step has these reasons, as JSON.
std::string reasoned(const std::string& reasons) {
  const std::string next = "}\n{\"run\":\"search\",\"step\":3";
  return changed(write_record(recorded("flood")), next, ",\"reasons\":" + reasons + next);
}

/// The same with these candidates, of which none was chosen; `more` overrides fields.
std::string with_candidates(const std::string& candidates, const std::string& more = "") {
  return reasoned(R"({"candidates":[)" + candidates + R"(],"chosen":-1,"known":0,"way_here":1,"hope":0,"price":0)" +
                  more + "}");
}

constexpr const char* wall = R"("wall":[0,0,"north"])";
constexpr const char* rest = R"("seen_from":[0,0],"through":3,"travel":1,"score":1.5)";

/// A candidate; of two fields with one name the last one counts.
std::string candidate(const std::string& more = "") { return fmt::format("{{{},{}{}}}", wall, rest, more); }
std::string goal(const std::string& more = "") { return fmt::format("{{\"goal\":true,{}{}}}", rest, more); }

TEST(RecordedReasons, MayLeaveOutWhatIsUsual) {
  const Reasons reasons = read(with_candidates(candidate() + "," + goal())).run.reasons.at(0).reasons;
  ASSERT_EQ(reasons.candidates.size(), 2U);
  EXPECT_EQ(reasons.candidates[0], (Candidate{{{0, 0}, Heading::north}, {0, 0}, false, 3, 1, true, 1.5}));
  EXPECT_EQ(reasons.candidates[1], (Candidate{{}, {0, 0}, true, 3, 1, true, 1.5}));
}

TEST(RecordedReasons, OfAnotherShapeAreRefusedWithTheirLine) {
  EXPECT_EQ(problem(reasoned("[]")).line, 3);
  EXPECT_EQ(problem(reasoned("[]")).column, 1);
  EXPECT_THAT(problem(reasoned("3")).reason, Says("'reasons'", "object"));
  EXPECT_THAT(problem(reasoned("null")).reason, Says("'reasons'", "object"));
  EXPECT_THAT(problem(reasoned("{}")).reason, Says("'reasons.candidates'", "missing"));
  EXPECT_THAT(problem(reasoned(R"({"candidates":{}})")).reason, Says("'reasons.candidates'", "list"));
  EXPECT_THAT(problem(with_candidates(goal() + ",3")).reason, Says("'reasons.candidates[1]'", "object"));
}

TEST(RecordedReasons, WithoutAFieldAreRefused) {
  for (const char* field : {"chosen", "known", "way_here", "hope", "price"})
    EXPECT_THAT(problem(changed(with_candidates(""), fmt::format("\"{}\"", field), "\"other\"")).reason,
                Says(fmt::format("'reasons.{}'", field), "missing"));
  for (const char* field : {"wall", "seen_from", "through", "travel", "score"})
    EXPECT_THAT(problem(changed(with_candidates(candidate()), fmt::format("\"{}\"", field), "\"other\"")).reason,
                Says(fmt::format("'reasons.candidates[0].{}'", field), "missing"));
}

TEST(RecordedReasons, WithAGroundThatIsNoneAreRefused) {
  EXPECT_THAT(problem(with_candidates(candidate(), R"(,"ground":"a whim")")).reason, HasSubstr("unknown 'ground'"));
}

TEST(RecordedReasons, WithAWrongWallAreRefused) {
  for (const char* bad :
       {"3", "[0,0]", R"([0,0,"south"])", R"([0,0,"north",1])", R"([0,99,"north"])", R"([4,0,"east"])",
        R"([0,4,"north"])", R"([0.5,0,"north"])", R"([["a",1],["b",1],"north"])", R"([20,20,"north"])"})
    EXPECT_THAT(problem(with_candidates(candidate(",\"wall\":" + std::string(bad)))).reason, HasSubstr("wall")) << bad;
  EXPECT_THAT(problem(with_candidates(goal("," + std::string(wall)))).reason, Says("both", "goal", "wall"));
}

TEST(RecordedReasons, WithValuesOutOfRangeAreRefused) {
  for (const char* bad : {R"("seen_from":[5,0])", R"("seen_from":[0])", R"("through":-1)", R"("through":1e3)",
                          R"("travel":2147483648)", R"("travel":-1)", R"("score":"1")", R"("score":1e10)",
                          R"("score":-1e10)", R"("score":null)", R"("worth":0)", R"("goal":"no")"})
    EXPECT_THAT(problem(with_candidates(candidate("," + std::string(bad)))).reason, HasSubstr("'reasons.candidates[0]"))
        << bad;
  for (const char* bad :
       {R"("chosen":1)", R"("chosen":-2)", R"("chosen":0.5)", R"("known":-1)", R"("known":1.5)", R"("way_here":1.5)",
        R"("way_here":-0.5)", R"("hope":-1)", R"("price":1e10)", R"("price":true)"})
    EXPECT_THAT(problem(with_candidates(candidate(), "," + std::string(bad))).reason, HasSubstr("'reasons.")) << bad;
}

TEST(RecordedReasons, OfMoreCandidatesThanThereAreWallsAreRefused) {
  // The maze has 25 cells.
  const auto many = [](int count) {
    std::string candidates = candidate();
    for (int i = 1; i < count; ++i) candidates += "," + candidate();
    return with_candidates(candidates);
  };
  EXPECT_EQ(read(many(50)).run.reasons.at(0).reasons.candidates.size(), 50U);
  EXPECT_THAT(problem(many(51)).reason, Says("'reasons.candidates'", "50"));
}

}  // namespace
}  // namespace labmouse
