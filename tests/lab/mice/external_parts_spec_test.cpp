// Built-in mice with parts of the controller in a program: their SPECs, and races of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/store/contest_key.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using test::Says;
using testing::HasSubstr;
using testing::SizeIs;

Contestant only(std::string_view spec, const ExternalOptions& options = {}) {
  SpecResult read = read_specs(spec, options);
  EXPECT_EQ(read.error, "") << spec;
  EXPECT_THAT(read.contestants, SizeIs(1)) << spec;
  return std::move(read.contestants.front());
}
std::shared_ptr<const World> world(const char* name, const WorldSettings& settings = {}) {
  return find_world(name)->make(settings).world;
}

TEST(PartsSpec, IsABuiltInMouseAndACommandToTheEnd) {
  const Contestant mouse = only("festina:safe=no:parts=sh -c a,b:c=d");
  EXPECT_EQ(mouse.name, "festina:safe=no:parts=sh -c a,b:c=d");
  EXPECT_EQ(mouse.settings.choice("safe"), "no");
  EXPECT_TRUE(mouse.parts);
  EXPECT_TRUE(mouse.external);
  EXPECT_TRUE(mouse.sandboxed.has_value());
  EXPECT_TRUE(mouse.drives());
  EXPECT_FALSE(mouse.walks());
  // In the shortest form, and under a name of its own.
  EXPECT_EQ(only("x=flood:parts=sh").name, "x");
  EXPECT_EQ(spec_of(only("x=flood:parts=sh")), "flood:parts=sh");
  const SpecResult two = read_specs("certify,flood:parts=sh");
  ASSERT_THAT(two.contestants, SizeIs(2)) << two.error;
  EXPECT_FALSE(two.contestants[0].parts);
  EXPECT_TRUE(two.contestants[1].parts);
  // Commands of other programs have them as words.
  for (const char* spec : {"program:sh a:parts=b", "controller:sh a:parts=b", "mms:sh a:parts=b", "pilot:sh a:parts=b"})
    EXPECT_FALSE(only(spec).parts) << spec;
}

TEST(PartsSpec, SaysWhatIsWrong) {
  for (const auto& [spec, words] : std::vector<std::pair<const char*, std::vector<std::string>>>{
           {"flood:parts=", {"empty"}},
           {"flood:parts=no-such-program-anywhere", {"no-such-program-anywhere", "PATH"}},
           {"fload:parts=sh", {"'fload'", "'flood'"}},
           {"flood:strid=1:parts=sh", {"'strid'"}},
           {"oracle:stride=1:parts=sh", {"oracle"}}}) {
    const SpecResult read = read_specs(spec);
    EXPECT_THAT(read.error, test::HasParts(words)) << spec;
    EXPECT_THAT(read.contestants, SizeIs(0)) << spec;
  }
}

TEST(PartsSpec, OfAFileIsRefusedUnread) {
  for (const char* spec :
       {"flood:parts=sh", "X=flood:parts=sh", "certify,flood:parts=sh", "festina:safe=no:parts=sh"}) {
    const SpecResult read = read_builtin_specs(spec);
    EXPECT_THAT(read.error, Says("starts", "no program")) << spec;
    EXPECT_THAT(read.contestants, SizeIs(0)) << spec;
  }
}

TEST(PartsSpec, RacesInThePhysicalWorldOnly) {
  const Contestant mouse = only("flood-return:parts=true");
  for (const WorldEntry* entry : all_worlds())
    EXPECT_EQ(entry->make({}).world->refuse(mouse).empty(), entry->name == "physical") << entry->name;
  for (const char* name : {"steps", "seconds", "failures"})
    EXPECT_THAT(world(name)->refuse(mouse), Says("'parts'", "no effect", "physical")) << name;
  EXPECT_EQ(world("physical", {{"rules", "time-trial"}})->refuse(mouse), "");
  EXPECT_NE(world("physical")->refuse(only("oracle:parts=true")), "");
  // A parameter does not change the world of a mouse without notice.
  EXPECT_THAT(enter({mouse}, "", {}).error, Says("'parts'", "--world physical"));
  EXPECT_EQ(enter({mouse}, "physical", {}).error, "");
}

TEST(PartsSpec, HasVariants) {
  const std::vector<std::string> values = {"yes", "no"};
  const SpecResult read = read_variants("festina:parts=sh", "safe", values);
  ASSERT_THAT(read.contestants, SizeIs(2)) << read.error;
  for (const Contestant& mouse : read.contestants) {
    EXPECT_TRUE(mouse.parts);
    EXPECT_THAT(mouse.name, testing::EndsWith(":parts=sh"));
  }
  EXPECT_NE(read.contestants[0].settings.choice("safe"), read.contestants[1].settings.choice("safe"));
  // One in the command is for the program.
  const SpecResult gains = read_variants("flood-return:parts=sh -c {gain}", "gain", values);
  ASSERT_THAT(gains.contestants, SizeIs(2)) << gains.error;
  EXPECT_EQ(gains.contestants[1].name, "flood-return:parts=sh -c no");
  EXPECT_TRUE(gains.contestants[1].parts);
  EXPECT_THAT(read_variants("flood-return:parts=sh", "gain", values).error, HasSubstr("'gain'"));
}

TEST(PartsSpec, IsSweptOverParametersOfBoth) {
  RaceOrder order;
  order.world = world("physical");
  order.runs = 1;
  for (const auto& [spec, parameter] : std::vector<std::pair<std::string, std::string>>{
           {"flood-return:parts=false {gain}", "gain"}, {"festina:parts=false", "safe"}}) {
    SweptValues variation;
    variation.parameter = parameter;
    variation.values = {"yes", "no"};
    const Sweep sweep = hold_sweep(spec, variation, {{"ring", test::ring()}}, order, {});
    EXPECT_EQ(sweep.error, "") << spec;
    ASSERT_THAT(sweep.points, SizeIs(2)) << spec;
    EXPECT_EQ(sweep.points[0].value, "yes");
  }
}

TEST(PartsSpec, KeysOfContestsNameBothAndTheProgramsFiles) {
  const fs::path folder = fs::temp_directory_path() / ("labmouse-parts-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const auto write = [&](const char* name, const char* text) {
    std::ofstream(folder / name) << text;
    fs::permissions(folder / name, fs::perms::owner_all);
  };
  write("a.sh", "#!/bin/sh\nexit 1\n");
  write("b.sh", "#!/bin/sh\nexit 2\n");
  ExternalOptions options;
  options.directory = folder.string();
  const auto key = [&](std::string_view spec) { return key_of(*world("physical"), only(spec, options)); };
  const std::string first = key("flood-return:parts=./a.sh");
  EXPECT_EQ(key("flood-return:parts=./a.sh"), first);
  EXPECT_EQ(key("mine=flood-return:parts=./a.sh"), first);
  EXPECT_THAT(first, HasSubstr("guest parts\n"));
  EXPECT_THAT(first, HasSubstr("mouse flood-return\n"));
  EXPECT_THAT(first, HasSubstr("signature "));
  for (const char* other : {"flood-return:parts=./b.sh", "flood-return:parts=./a.sh 1", "certify:parts=./a.sh",
                            "festina:safe=no:parts=./a.sh", "flood-return", "controller:./a.sh"})
    EXPECT_NE(key(other), first) << other;
  write("a.sh", "#!/bin/sh\nexit 3\n");
  EXPECT_NE(key("flood-return:parts=./a.sh"), first);
  fs::remove_all(folder);
}

TEST(PartsSpec, StandsInMiceFilesWithTheKeysOfPrograms) {
  // A folder of its own: the identity of a mouse is that of the files beside it, too.
  const fs::path folder = fs::temp_directory_path() / ("labmouse-parts-file-" + std::to_string(getpid()));
  const fs::path file = folder / "mice.toml";
  fs::create_directories(folder);
  const auto read = [&](const std::string& text) {
    std::ofstream(file) << text;
    return read_specs("mice-file:" + file.string());
  };
  const SpecResult mice = read(
      "[[mouse]]\nname = \"mine\"\nmouse = \"festina:safe=no:parts=sh\"\narguments = [\"-c\", \"{n}\"]\n"
      "limits = { silence = 5 }\nnote = \"by me\"\n");
  ASSERT_THAT(mice.contestants, SizeIs(1)) << mice.error;
  EXPECT_EQ(mice.contestants[0].name, "mine");
  EXPECT_EQ(mice.contestants[0].note, "by me");
  EXPECT_TRUE(mice.contestants[0].parts);
  EXPECT_THAT(mice.contestants[0].identity(), HasSubstr("word -c\n"));
  const std::vector<std::string> values = {"1", "2"};
  EXPECT_THAT(read_variants("mice-file:" + file.string(), "n", values).contestants[1].identity(),
              HasSubstr("word 2\n"));
  const SpecResult own = read_variants("mice-file:" + file.string(), "safe", std::vector<std::string>{"yes"});
  ASSERT_THAT(own.contestants, SizeIs(1)) << own.error;
  EXPECT_TRUE(own.contestants[0].parts);
  EXPECT_NE(read("[[mouse]]\nname = \"mine\"\nmouse = \"flood-return\"\narguments = [\"-c\"]\n").error, "");
  fs::remove_all(folder);
}

#if defined(LABMOUSE_PART_PROGRAM) && defined(LABMOUSE_BAD_PROGRAM)

std::vector<Contestant> mice(const std::string& spec) {
  ExternalOptions options;
  options.limits.silence = options.limits.contest = std::chrono::minutes(5);
  return {only(spec, options)};
}
std::shared_ptr<const World> minute() {
  DriveRules rules = find_rules("all-japan").rules;
  rules.time_limit = 20'000'000;
  return physical_world(rules, test::drive_model("kerise"), test::at_variation(0.0));
}
Race race(std::vector<Contestant> mice, const RaceHooks& hooks = {}) {
  RaceOrder order;
  order.world = minute();
  order.runs = 2;
  return hold_race(std::move(mice), {{"ring", test::ring()}}, order, hooks);
}

TEST(PartsRace, IsThatOfTheMouseItselfWhereThePartsAreTheSame) {
  LABMOUSE_SKIP_SANITIZED();
  // The wall detector needs nothing that a program is not told.
  std::string record;
  RaceHooks hooks;
  hooks.keep = [](const ContestResult&) { return Keep{true, true}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) {
    record = held.record;
    EXPECT_THAT(held.picture, HasSubstr("<svg"));
  };
  const Race own = race({only("flood-return")}),
             other = race(mice("flood-return:parts=\"" LABMOUSE_PART_PROGRAM "\" reader"), hooks);
  ASSERT_THAT(other.results, SizeIs(2));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(own.results[i].score);
    const StoredFigures& all = own.world().traits().fields->figures;
    EXPECT_EQ(all.values_of(*own.results[i].figures), all.values_of(*other.results[i].figures));
    EXPECT_EQ(own.results[i].score, other.results[i].score);
  }
  const ReadDriveRecordResult read = read_drive_record(record);
  ASSERT_TRUE(read.file);
  EXPECT_TRUE(read.file->physical->notes.foreign_parts);
  EXPECT_THAT(replay(*read.file), Says("not", "driven", "again"));
}

TEST(PartsRace, TellsWhyPartsGaveUp) {
  const Race held = race(mice("flood-return:parts=\"" LABMOUSE_BAD_PROGRAM "\" \"part rubbish\""));
  for (const ContestResult& result : held.results) {
    EXPECT_FALSE(result.score);
    EXPECT_EQ(result.never_started, "");
  }
  EXPECT_THAT(table_of(held, false), Says("invalid answer", "'what?'"));
  const Race ended = race(mice("flood-return:parts=\"" LABMOUSE_BAD_PROGRAM "\" \"part end at the start\""));
  for (const ContestResult& result : ended.results) EXPECT_THAT(result.never_started, HasSubstr("labmouse pilot 1"));
}

#endif

}  // namespace
}  // namespace labmouse
