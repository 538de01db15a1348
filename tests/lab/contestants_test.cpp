#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

using ::testing::ElementsAre;

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
  EXPECT_EQ(refuse_to_drive(read_specs("flood,wall-left,random").contestants),
            "mouse 'wall-left' does not drive in seconds; those that do are flood, flood-return, certify, ariadne");
  EXPECT_NE(refuse_to_drive(read_specs("oracle").contestants), "");
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
  EXPECT_EQ(error("flood:stride=1:stride=2"), "parameter 'stride' of mouse 'flood' is given twice");
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

TEST(Spec, AllContestantsAreTheRoster) {
  const auto all = all_contestants();
  ASSERT_EQ(all.size(), roster().size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].name, roster()[i]->name);
}

TEST(SpecError, AnUnknownMouseIsNamedWithTheNearest) {
  EXPECT_EQ(error("flod"), "mouse 'flod' is unknown; did you mean 'flood'? `labmouse mice` lists all");
  EXPECT_EQ(error("elephantine"), "mouse 'elephantine' is unknown; `labmouse mice` lists all");
}

TEST(SpecError, AMouseWithoutAName) {
  const char* reason = "a mouse without a name; write name[:key=value]..., several separated by commas";
  EXPECT_EQ(error(""), reason);
  EXPECT_EQ(error("flood,"), reason);
  EXPECT_EQ(error(",flood"), reason);
  EXPECT_EQ(error(":stride=1"), reason);
}

TEST(SpecError, AnUnknownParameterIsNamedWithTheNearest) {
  EXPECT_EQ(error("flood:strid=1"), "mouse 'flood' has no parameter 'strid'; did you mean 'stride'?");
  EXPECT_EQ(error("flood:whiskers=1"), "mouse 'flood' has no parameter 'whiskers'; it has stride");
  EXPECT_EQ(error("certify:stride=1"), "mouse 'certify' has no parameters, so none called 'stride'");
}

TEST(SpecError, AValueIsMissing) {
  EXPECT_EQ(error("flood:stride"), "'stride' of mouse 'flood' is not of the form key=value");
  EXPECT_EQ(error("flood:"), "'' of mouse 'flood' is not of the form key=value");
}

TEST(SpecError, AValueIsOutOfRangeOrNone) {
  for (const std::string value : {"0", "9", "-1", "1.5", "x", "", "1e3", " 1", "999999999999999999999"})
    EXPECT_EQ(error("flood:stride=" + value).find("value '" + value + "' of parameter 'stride' of mouse 'flood' "), 0U)
        << value;
}

TEST(SpecError, OneBadMouseSpoilsTheLot) { error("flood,certify,flod"); }

TEST(SpecError, TheOracleHasNoParameters) { EXPECT_EQ(error("oracle:stride=1"), "the oracle has no parameters"); }

TEST(Specs, TakeHalfANameForTheWholeWhenTheySuggest) {
  EXPECT_THAT(read_specs("phases:searching=wall").error, testing::HasSubstr("did you mean 'wall-follower'?"));
  EXPECT_THAT(read_specs("counter").error, testing::HasSubstr("did you mean 'visit-counter'?"));
  EXPECT_THAT(read_specs("xyz").error, testing::Not(testing::HasSubstr("did you mean")));
}

}  // namespace
}  // namespace labmouse
