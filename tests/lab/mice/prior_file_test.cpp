#include "labmouse/lab/mice/prior_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "labmouse/chance/rng.hpp"
#include "labmouse/mouse/priors.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using test::SaysAt;
using ::testing::HasSubstr;
using ::testing::StartsWith;

WallPrior any_prior() {
  Rng rng(1);
  WallPrior prior{};
  for (auto& number : prior.walls) number = static_cast<std::uint8_t>(rng.below(256));
  for (auto& number : prior.rim) number = static_cast<std::uint8_t>(rng.below(256));
  return prior;
}

std::string any_file() { return write_prior(any_prior(), {"0.1.0", {{16, 16}}, {100, 0.5, 0.6}}); }

/// A file with that many zeros, one a line.
std::string zeros(int count) {
  std::string text = "// labmouse prior 1\n";
  for (int i = 0; i < count; ++i) text += "0,\n";
  return text;
}

constexpr int all_numbers = 6561 + 24;

TEST(PriorFile, SurvivesBeingWrittenAndRead) {
  const ReadPriorResult read = read_prior(any_file());
  EXPECT_THAT(read.problems, testing::IsEmpty());
  EXPECT_EQ(read.prior, any_prior());
}

TEST(PriorFile, SaysWhereItComesFrom) {
  const std::string text =
      write_prior(any_prior(), {"1.2.3", {{16, 16}, {9, 5}, {16, 16}, {5, 9}}, {12345, 0.51249, 0.69}});
  EXPECT_THAT(text, StartsWith("// labmouse prior 1\n"
                               "// Learned by labmouse 1.2.3 from 4 mazes.\n"
                               "// Sizes: 1 of 5x9, 1 of 9x5, 2 of 16x16.\n"));
  EXPECT_THAT(text, Says("\n// 12345 walls", "0.512 nats", "0.690 "));
  EXPECT_THAT(any_file(), HasSubstr(" from 1 maze.\n"));
}

TEST(PriorFile, KeepsWhatIsSaidOfItInComments) {
  const std::string text = write_prior(any_prior(), {"1\n2,\r3", {}, {}});
  EXPECT_EQ(read_prior(text).prior, any_prior());
}

TEST(PriorFile, HasLinesThatFitAScreen) {
  const std::string text = any_file();
  std::string_view rest = text;
  for (std::size_t end; (end = rest.find('\n')) != std::string_view::npos; rest.remove_prefix(end + 1))
    EXPECT_LE(end, 120U);
  EXPECT_TRUE(rest.empty());
}

TEST(PriorFile, MayHaveOtherLinesCommentsBlanksAndLineEnds) {
  std::string text = any_file();
  text.insert(text.find('\n') + 1, "// another comment\n//\n");
  text.insert(text.find(",\n") + 2, "// in the middle\n");
  for (auto at = text.find(','); at < 3000; at = text.find(',', at + 3)) text.insert(at + 1, " ");
  EXPECT_EQ(read_prior(text).prior, any_prior());
  std::string carriage;
  for (const char letter : text) carriage += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  EXPECT_EQ(read_prior(carriage).prior, any_prior());
  EXPECT_TRUE(read_prior(zeros(all_numbers) + "\n \n").prior.has_value());
}

std::string reason(std::string_view text) {
  const ReadPriorResult read = read_prior(text);
  EXPECT_FALSE(read.prior.has_value());
  if (read.problems.empty()) return "";
  const Problem& problem = read.problems.front();
  return std::to_string(problem.line) + ":" + std::to_string(problem.column) + ": " + problem.reason;
}

TEST(BadPriorFile, HasAnotherFirstLine) {
  const auto expected = SaysAt("1:1", "not a prior", "'// labmouse prior 1'");
  EXPECT_THAT(reason(""), expected);
  EXPECT_THAT(reason("\n" + any_file()), expected);
  EXPECT_THAT(reason("// labmouse prior 2\n0,\n"), expected);
  EXPECT_THAT(reason("// labmouse prior 1 or so\n0,\n"), expected);
  EXPECT_THAT(reason("0,0,\n"), expected);
}

TEST(BadPriorFile, HasSomethingElseWhereANumberShouldBe) {
  const auto with = [](const std::string& line) { return zeros(10) + line + "\n" + zeros(all_numbers).substr(20); };
  EXPECT_THAT(reason(with("1,256,")), SaysAt("12:3", "0 to 255", "'256'"));
  EXPECT_THAT(reason(with("1, -1,")), SaysAt("12:4", "0 to 255", "'-1'"));
  EXPECT_THAT(reason(with("07,")), SaysAt("12:1", "0 to 255", "'07'"));
  EXPECT_THAT(reason(with("1.5,")), SaysAt("12:1", "0 to 255", "'1.5'"));
  EXPECT_THAT(reason(with("1 2,")), SaysAt("12:1", "0 to 255", "'1 2'"));
  EXPECT_THAT(reason(with("1,,2,")), SaysAt("12:3", "0 to 255", "''"));
  EXPECT_THAT(reason(with("")), SaysAt("12:1", "0 to 255", "''"));
  EXPECT_THAT(reason(with(",")), SaysAt("12:1", "0 to 255", "''"));
  EXPECT_THAT(reason(with("1, // one")), SaysAt("12:4", "0 to 255", "'// one'"));
  EXPECT_THAT(reason(with("\x1b[31m,")), SaysAt("12:1", "0 to 255", "'\\x1b[31m'"));
}

TEST(BadPriorFile, HasNoCommaAtTheEndOfALine) {
  EXPECT_THAT(reason("// labmouse prior 1\n1,2,3\n4,"), SaysAt("2:6", "comma"));
  std::string text = any_file();
  text.resize(text.size() - 2);
  EXPECT_THAT(reason(text), HasSubstr("comma"));
}

TEST(BadPriorFile, HasTooFewOrTooManyNumbers) {
  EXPECT_TRUE(read_prior(zeros(all_numbers)).prior.has_value());
  EXPECT_THAT(reason(zeros(all_numbers - 1)), SaysAt("6585:3", "6585 numbers", "6584"));
  EXPECT_THAT(reason(zeros(all_numbers + 1)), SaysAt("6587:1", "6585 numbers", "more"));
  EXPECT_THAT(reason("// labmouse prior 1\n"), SaysAt("1:20", "6585 numbers", "0"));
  EXPECT_EQ(read_prior(zeros(2 * all_numbers)).problems.size(), 1U);
  std::string in_one_line = zeros(3 * all_numbers);
  std::erase(in_one_line, '\n');
  in_one_line.insert(19, "\n");
  EXPECT_THAT(reason(in_one_line), Says("6585 numbers", "more"));
}

TEST(BadPriorFile, IsTooLarge) {
  const std::string text = zeros(all_numbers);
  EXPECT_TRUE(read_prior(text + std::string((1U << 20U) - text.size(), ' ')).prior.has_value());
  EXPECT_THAT(reason(text + std::string((1U << 20U) - text.size() + 1, ' ')),
              SaysAt("0:0", "1048577 bytes", "1048576"));
}

TEST(BadPriorFile, HasAFewOfItsProblemsListed) {
  std::string text = "// labmouse prior 1\n";
  for (int i = 0; i < 100; ++i) text += "x,\n";
  EXPECT_EQ(read_prior(text).problems.size(), most_problems);
}

std::string source(const std::string& name) {
  std::ifstream file(LABMOUSE_SOURCE_DIR "/labmouse/mouse/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(PriorFile, IsWhatThePriorsOfLabmouseAreMadeFrom) {
  EXPECT_EQ(read_prior(source("contest.prior")).prior, contest_prior);
  EXPECT_EQ(read_prior(source("loop_free.prior")).prior, loop_free_prior);
  EXPECT_FALSE(contest_prior == loop_free_prior);
}

}  // namespace
}  // namespace labmouse
