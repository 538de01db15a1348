#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> names(std::string_view specs) {
  const SpecResult result = read_specs(specs);
  EXPECT_EQ(result.error, "");
  std::vector<std::string> list;
  for (const Contestant& contestant : result.contestants) list.push_back(contestant.name);
  return list;
}

std::string error(std::string_view specs) {
  const SpecResult result = read_specs(specs);
  EXPECT_TRUE(result.contestants.empty());
  return result.error;
}

TEST(Contestants, DriveInSecondsOrSayWhoDoes) {
  EXPECT_EQ(refuse_to_drive(read_specs("flood,certify,ariadne,flood-return").contestants), "");
  EXPECT_THAT(refuse_to_drive(read_specs("flood,wall-left,random").contestants),
              Says("'wall-left'", "seconds", "flood, flood-return, certify, ariadne"));
  EXPECT_NE(refuse_to_drive(read_specs("oracle").contestants), "");
}

TEST(Contestants, HaveParametersOfTheWorldThatTheyAreIn) {
  const Contestant walker = read_specs("ariadne:travel=3").contestants.front();
  EXPECT_EQ(refuse_to_walk(walker), "");
  EXPECT_THAT(refuse_to_drive({&walker, 1}), Says("'travel'", "seconds", "labmouse mice ariadne"));
  const Contestant driver = read_specs("ariadne:cell_most=1").contestants.front();
  EXPECT_EQ(refuse_to_drive({&driver, 1}), "");
  EXPECT_THAT(refuse_to_walk(driver), Says("'cell_most'", "steps", "labmouse mice ariadne"));
  const Contestant both = read_specs("ariadne:prior=uniform").contestants.front();
  EXPECT_EQ(refuse_to_walk(both) + refuse_to_drive({&both, 1}), "");
}

TEST(Contestants, HaveParametersThatCountWhereThingsGoWrongAlone) {
  for (const char* spec : {"festina:search=0.5", "festina:slower=0.5", "festina:run=0.5", "festina:step=0.5",
                           "festina:safe=no", "festina:map=log-odds-prior"}) {
    const Contestant mouse = read_specs(spec).contestants.front();
    EXPECT_THAT(refuse_to_drive({&mouse, 1}),
                Says("'festina'", "seconds", "physical", "failure model", "labmouse mice festina"))
        << spec;
    EXPECT_EQ(refuse_to_drive({&mouse, 1}, Driving::with_errors), "") << spec;
  }
  const Contestant ideal = read_specs("festina:strategy=certify").contestants.front();
  EXPECT_EQ(refuse_to_drive({&ideal, 1}) + refuse_to_drive({&ideal, 1}, Driving::with_errors), "");
  const Contestant walker = read_specs("ariadne:travel=3").contestants.front();
  EXPECT_THAT(refuse_to_drive({&walker, 1}, Driving::with_errors), Says("'travel'", "steps"));
}

TEST(Contestants, SaveTheSettingsThatCount) {
  const Contestant mouse = read_specs("ariadne:cell_most=1").contestants.front();
  const Settings driven = settings_in_seconds(mouse), walked = settings_in_steps(mouse);
  EXPECT_THAT(driven.all(), ElementsAre(Setting{"prior", "contest"}, Setting{"cell_most", "1"}));
  EXPECT_THAT(walked.all(), Contains(Setting{"travel", "40.57"}));
  EXPECT_THAT(walked.all(), Not(Contains(Setting{"cell_most", "1"})));
}

TEST(Spec, NamesAMouse) { EXPECT_THAT(names("flood"), ElementsAre("flood")); }

TEST(Spec, NamesSeveral) { EXPECT_THAT(names("flood,certify,random"), ElementsAre("flood", "certify", "random")); }

TEST(Spec, SetsAParameter) {
  const auto mice = read_specs("flood:stride=1").contestants;
  ASSERT_EQ(mice.size(), 1U);
  EXPECT_EQ(mice[0].name, "flood:stride=1");
  EXPECT_EQ(mice[0].settings.whole("stride"), 1);
}

TEST(Spec, TheNameLeavesDefaultsOut) { EXPECT_THAT(names("flood:stride=3"), ElementsAre("flood")); }

TEST(SpecError, AParameterIsGivenTwice) {
  EXPECT_THAT(error("flood:stride=1:stride=2"), Says("'stride'", "'flood'", "twice"));
}

TEST(Spec, AValueHasOneSpelling) {
  EXPECT_THAT(names("flood:stride=02,flood:stride=2,flood:stride=2.0"), ElementsAre("flood:stride=2"));
  EXPECT_THAT(names("flood:stride=003"), ElementsAre("flood"));
}

TEST(Spec, AMouseThatStandsTwiceRacesOnce) {
  EXPECT_THAT(names("flood,flood:stride=3,certify,flood"), ElementsAre("flood", "certify"));
  EXPECT_THAT(names("flood,flood:stride=1"), ElementsAre("flood", "flood:stride=1"));
}

TEST(Spec, TheOracleIsNoContestant) {
  const auto mice = read_specs("oracle,flood").contestants;
  EXPECT_TRUE(mice[0].reference);
  EXPECT_FALSE(mice[1].reference);
}

TEST(Spec, AllContestantsAreTheBuiltinMice) {
  const auto all = all_contestants();
  ASSERT_EQ(all.size(), all_mice().size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].name, all_mice()[i]->name);
}

TEST(SpecError, AnUnknownMouseIsNamedWithTheNearest) {
  EXPECT_THAT(error("flod"), Says("'flod'", "'flood'", "`labmouse mice`"));
  EXPECT_THAT(error("elephantine"), AllOf(Says("'elephantine'", "`labmouse mice`"), Not(HasSubstr("did you mean"))));
}

TEST(SpecError, AMouseWithoutAName) {
  const auto reason = Says("no name", "name[:key=value]");
  EXPECT_THAT(error(""), reason);
  EXPECT_THAT(error("flood,"), reason);
  EXPECT_THAT(error(",flood"), reason);
  EXPECT_THAT(error(":stride=1"), reason);
}

TEST(SpecError, AnUnknownParameterIsNamedWithTheNearest) {
  EXPECT_THAT(error("flood:strid=1"), Says("'flood'", "'strid'", "'stride'"));
  EXPECT_THAT(error("flood:whiskers=1"), Says("'flood'", "'whiskers'", " stride"));
  EXPECT_THAT(error("certify:stride=1"), Says("'certify'", "no parameters", "'stride'"));
}

TEST(SpecError, AValueIsMissing) {
  EXPECT_THAT(error("flood:stride"), Says("'stride'", "'flood'", "key=value"));
  EXPECT_THAT(error("flood:"), Says("''", "'flood'", "key=value"));
}

TEST(SpecError, AValueIsOutOfRangeOrNone) {
  for (const std::string value : {"0", "9", "-1", "1.5", "x", "", "1e3", " 1", "999999999999999999999"})
    EXPECT_THAT(error("flood:stride=" + value), Says("value '" + value + "'", "'stride'", "'flood'"));
}

TEST(SpecError, OneBadMouseSpoilsTheLot) { error("flood,certify,flod"); }

TEST(SpecError, TheOracleHasNoParameters) { EXPECT_THAT(error("oracle:stride=1"), Says("oracle", "no parameters")); }

TEST(Specs, TakeHalfANameForTheWholeWhenTheySuggest) {
  EXPECT_THAT(read_specs("phases:searching=wall").error, Says("did you mean", "'wall-follower'"));
  EXPECT_THAT(read_specs("counter").error, Says("did you mean", "'visit-counter'"));
  EXPECT_THAT(read_specs("xyz").error, Not(HasSubstr("did you mean")));
}

}  // namespace
}  // namespace labmouse
