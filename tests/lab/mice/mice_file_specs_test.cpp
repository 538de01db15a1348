// Mice with names: of a mice file, and of NAME=SPEC.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "labmouse/lab/hindsight/hindsight.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/studies/parameter_range.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using test::Says;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Mice files in a folder of their own.
class AMiceFile : public testing::Test {
 protected:
  ~AMiceFile() override { fs::remove_all(folder_); }

  /// The SPEC of a mice file with that text.
  std::string mice_file(const std::string& text, const fs::path& name = "mice.toml") const {
    return "mice-file:" + file(name, text);
  }
  std::string file(const fs::path& name, const std::string& content, bool executable = false) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << content;
    if (executable) fs::permissions(folder_ / name, fs::perms::owner_all);
    return folder_ / name;
  }

  fs::path folder_ = fs::temp_directory_path() / ("labmouse-mice-file-" + std::to_string(getpid()));
};

/// How the mouse of that place is started, a program that talks to mms.
const Launch& program_of(const SpecResult& read, std::size_t place) {
  return std::get<MmsProgram>(read.contestants[place].kind).launch;
}

SpecResult read_all(const std::vector<std::string>& specs) { return read_specs(specs); }

TEST(NamedMouse, KeepsItsSpec) {
  const SpecResult read = read_specs("fast=flood:stride=03,flood");
  ASSERT_THAT(read.contestants, SizeIs(2)) << read.error;
  EXPECT_EQ(read.contestants[0].name, "fast");
  EXPECT_EQ(spec_of(read.contestants[0]), "flood");
  EXPECT_EQ(spec_of(read.contestants[1]), "flood");
  EXPECT_FALSE(std::holds_alternative<MmsProgram>(read_specs("a=program:sh -c b=c").contestants.front().kind));
  EXPECT_EQ(spec_of(read_specs("a=mms:sh -c b=c").contestants.front()), "mms:sh -c b=c");
}

TEST(NamedMouse, SharesItsNameWithNoOther) {
  EXPECT_THAT(read_specs("a=flood,a=certify").error, Says("'a'", "flood", "certify", "NAME=SPEC"));
  EXPECT_THAT(read_specs("a=flood,a=flood:stride=3").contestants, SizeIs(1));
  EXPECT_THAT(read_specs("flood=flood,flood").contestants, SizeIs(1));
}

TEST(NamedMouse, IsKnownByItsSpecAndNotByItsName) {
  // It is called like another mouse, which has other parameters.
  const std::vector<Contestant> mice = read_specs("ariadne=flood,flood=ariadne").contestants;
  EXPECT_EQ(refuse_to_drive(mice), "");
  EXPECT_THAT(settings_in_seconds(mice[0]).all(), IsEmpty());
  EXPECT_THAT(settings_in_seconds(mice[1]).all(), SizeIs(1));
  EXPECT_THAT(refuse_to_drive(read_specs("a=flood:stride=1").contestants), Says("'stride'", "'flood'", "no effect"));
  EXPECT_THAT(perturbed(read_specs("flood=cautious").contestants.front(), 3, 1), SizeIs(testing::Gt(0U)));
}

TEST(NamedMouse, IsSweptAndTunedAsWhatItIs) {
  const std::vector<std::string> strides = {"1", "2"};
  const SpecResult variants = read_variants("fast=flood", "stride", strides);
  ASSERT_THAT(variants.contestants, SizeIs(2)) << variants.error;
  EXPECT_EQ(variants.contestants[1].name, "flood:stride=2");
  EXPECT_THAT(read_ranges("fast=flood", "stride").ranges, SizeIs(1));
  const Sweep sweep = hold_sweep("fast=flood", read_swept_values("stride=1,2"), {test::loop()}, test::in_steps());
  EXPECT_EQ(sweep.error, "");
  EXPECT_THAT(sweep.points, SizeIs(2));
  EXPECT_THAT(read_variants("a=program:sh -c {x}", "x", strides).contestants, SizeIs(2));
  EXPECT_THAT(read_ranges("a=program:sh", "stride").error, Says("'a'", "no parameters"));
}

TEST_F(AMiceFile, HasMiceWhoseNamesHaveColons) {
  const std::string spec = mice_file("[[mouse]]\nname = \"a: b:c\"\nmouse = \"flood\"\n");
  for (const std::string& each : {spec, spec + ":a: b:c"}) {
    const SpecResult read = read_specs(each);
    ASSERT_THAT(read.contestants, SizeIs(1)) << read.error;
    EXPECT_EQ(read.contestants.front().name, "a: b:c");
  }
  EXPECT_THAT(read_specs(spec + ":b:c").error, Says("'b:c'"));
  EXPECT_THAT(read_specs(spec + ",flood").error, Says("mice.toml,flood", "before it"));
}

TEST_F(AMiceFile, IsToldWhatIsWrongWithItWithThePlaces) {
  const std::string spec = mice_file(
      "[[mouse]]\nname = \"a\"\nmouse = \"flod\"\n[[mouse]]\nname = \"b\"\nprogram = \"sh\"\ndirectory = \"none\"\n"
      "[[mouse]]\nname = \"c\"\nmouse = \"capstone:robot.py\"\n[[mouse]]\nname = \"d\"\nmouse = \"certify\"\n");
  const SpecResult read = read_specs(spec);
  EXPECT_THAT(read.contestants, IsEmpty());
  EXPECT_THAT(read.error, Says("'flood'"));
  const std::string file = spec.substr(spec.find(':') + 1);
  EXPECT_THAT(read.problems, ElementsAre(test::SaysAt(file + ":1:1", " error: ", "'a'", "'flood'"),
                                         test::SaysAt(file + ":4:1", " error: ", "'b'", "folder", "none"),
                                         test::SaysAt(file + ":8:1", " error: ", "'c'", "capstone = \"...\"")));
}

TEST_F(AMiceFile, HasNoPlaceForWhatIsWrongWithAllOfIt) {
  const std::string spec = mice_file("# " + std::string(70'000, '.') + "\n");
  const SpecResult read = read_specs(spec);
  const std::string file = spec.substr(spec.find(':') + 1);
  EXPECT_THAT(read.problems, ElementsAre(test::SaysAt(file, " error: ", "too large")));
  EXPECT_THAT(read.error, test::SaysAt("mice file " + file, "too large"));
}

TEST_F(AMiceFile, SharesNamesWithNoOther) {
  // Their SPECs are the same, but each is started in its own folder.
  const std::string text = "[[mouse]]\nname = \"team\"\nprogram = \"./mouse\"\n";
  file("a/mouse", "#!/bin/sh\n", true);
  file("b/mouse", "#!/bin/sh\n", true);
  const std::string a = mice_file(text, "a/mice.toml"), b = mice_file(text, "b/mice.toml");
  EXPECT_THAT(read_all({a, b}).error, Says("'team'", "a/mice.toml", "b/mice.toml"));
  EXPECT_THAT(read_all({a, a + ":team"}).contestants, SizeIs(1));
}

TEST_F(AMiceFile, FindsInterpretersFromItsFolder) {
  file("class/anna/bin/run", "#!/bin/sh\n", true);
  const std::string spec = mice_file(
      "[[mouse]]\nname = \"anna\"\nmms = \"main.x\"\ninterpreter = \"anna/bin/run\"\narguments = [\"-v\"]\n"
      "[[mouse]]\nname = \"ben\"\nmms = \"main.x\"\ninterpreter = \"sh\"\ndirectory = \"anna\"\n",
      "class/mice.toml");
  const SpecResult read = read_specs(spec);
  ASSERT_THAT(read.contestants, SizeIs(2)) << read.error;
  EXPECT_THAT(program_of(read, 0).words, ElementsAre(folder_ / "class/anna/bin/run", "main.x", "-v"));
  EXPECT_EQ(fs::path(program_of(read, 0).directory), folder_ / "class");
  EXPECT_THAT(program_of(read, 1).words, ElementsAre("sh", "main.x"));
  EXPECT_EQ(fs::path(program_of(read, 1).directory), folder_ / "class/anna");
}

TEST_F(AMiceFile, HasMiceThatCanBeSwept) {
  const std::string spec = mice_file(
      "[[mouse]]\nname = \"ours\"\nmouse = \"flood:stride=1\"\n"
      "[[mouse]]\nname = \"theirs\"\nmms = \"sh -c\"\narguments = [\"go {n}\"]\nenvironment = { N = \"{n}\" }\n");
  const std::vector<std::string> values = {"2", "3"};
  const SpecResult ours = read_variants(spec + ":ours", "stride", values);
  ASSERT_THAT(ours.contestants, SizeIs(2)) << ours.error;
  EXPECT_EQ(ours.contestants[0].settings.whole("stride"), 2);
  EXPECT_THAT(read_ranges(spec + ":ours", "stride").ranges, SizeIs(1));
  const SpecResult theirs = read_variants(spec + ":theirs", "n", values);
  ASSERT_THAT(theirs.contestants, SizeIs(2)) << theirs.error;
  EXPECT_THAT(program_of(theirs, 1).words, ElementsAre("sh", "-c", "go 3"));
  EXPECT_THAT(program_of(theirs, 1).environment, testing::Contains("N=3"));
  EXPECT_THAT(read_variants(spec + ":theirs", "m", values).error, Says("'theirs'", "{m}"));
  EXPECT_THAT(read_variants(spec + ":ours", "strid", values).error, Says("'strid'", "'stride'"));
  EXPECT_THAT(read_variants(mice_file("[[mouse]]\nname = \"a\"\nmouse = \"flood\"\n"
                                      "[[mouse]]\nname = \"b\"\nmouse = \"flood\"\n"),
                            "stride", values)
                  .error,
              Says("2 mice", "exactly one"));
}

TEST(ReadBuiltinSpecs, StartsNothingAndOpensNoMiceFile) {
  EXPECT_THAT(read_builtin_specs("X=flood:stride=1,certify").contestants, SizeIs(2));
  for (const char* spec : {"program:sh", "X=program:sh", "flood,program:sh", "capstone:robot.py", "mms:sh",
                           "controller:sh", "mice-file:mice.toml", "flood,mice-file:mice.toml"}) {
    const SpecResult read = read_builtin_specs(spec);
    EXPECT_NE(read.error, "") << spec;
    EXPECT_THAT(read.contestants, SizeIs(0)) << spec;
  }
  EXPECT_THAT(read_builtin_specs("ariadne:prior=/dev/null").error, Says("/dev/null", "device")) << "could be a pipe";
}

}  // namespace
}  // namespace labmouse
