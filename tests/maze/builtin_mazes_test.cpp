// The mazes of the folder mazes/ against the table in mazes/PROVENANCE.md, which says how each was made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "labmouse/maze/contest_rules.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/maze/wall_follower.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

const std::filesystem::path folder = LABMOUSE_SOURCE_DIR "/mazes";

struct Row {
  std::string file;
  std::string made_by;
  std::string size;
  std::string seed;
  std::string loops;

  GeneratorOrder order() const {
    const std::size_t by = size.find('x');
    return {{std::stoi(size.substr(0, by)), std::stoi(size.substr(by + 1))}, std::stoull(seed), std::stoi(loops)};
  }
};

std::string content_of(const std::string& file) {
  std::ifstream in(folder / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The cells of a line of a Markdown table, without the spaces around them.
std::vector<std::string> table_cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
  }
  return cells;
}

std::vector<Row> provenance() {
  std::vector<Row> rows;
  std::istringstream in(content_of("PROVENANCE.md"));
  for (std::string line; std::getline(in, line);) {
    if (line.find(".txt |") == std::string::npos) continue;
    const auto cells = table_cells(line);
    EXPECT_EQ(cells.size(), 6U) << line;
    if (cells.size() >= 5) rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4]});
  }
  return rows;
}

TEST(BuiltinMazes, EachHasItsProvenance) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".txt") files.push_back(entry.path().filename().string());
  std::vector<std::string> listed;
  for (const Row& row : provenance()) listed.push_back(row.file);
  EXPECT_THAT(listed, testing::UnorderedElementsAreArray(files));
}

TEST(BuiltinMazes, AreWhatTheirGeneratorsMake) {
  LABMOUSE_SKIP_SANITIZED();
  int generated = 0;
  for (const Row& row : provenance()) {
    const Generator* const generator = find_generator(row.made_by);
    if (generator == nullptr) continue;
    ++generated;
    EXPECT_EQ(generator->refuses(row.order()), "") << row.file;
    EXPECT_EQ(drawing_format.write(generator->make(row.order())).content, content_of(row.file)) << row.file;
  }
  EXPECT_EQ(generated, 34);
}

TEST(BuiltinMazes, CanBeReadAndSolved) {
  for (const Row& row : provenance()) {
    const auto maze = read_maze(content_of(row.file)).maze;
    ASSERT_TRUE(maze) << row.file;
    EXPECT_TRUE(shortest_in_cells(*maze)) << row.file;
  }
}

TEST(BuiltinMazes, ContestMazesKeepTheRules) {
  for (const Row& row : provenance()) {
    if (!row.file.starts_with("contest-")) continue;
    const auto findings = check_contest_rules(read_maze(content_of(row.file)).maze.value());
    const bool official = row.size == "16x16" || row.size == "32x32";
    for (const RuleFinding& rule : findings)
      EXPECT_TRUE(rule.passed || (rule.name == "size" && !official))
          << row.file << ": " << rule.name << ": " << rule.reason;
  }
}

TEST(BuiltinMazes, TestMazeOneHasARunOfSeventeenSteps) {
  EXPECT_EQ(shortest_in_strides(read_maze(content_of("capstone-1.txt")).maze.value())->strides, 17);
}

TEST(BuiltinMazes, TheMazesOfTheReportsHaveTheirShortestRuns) {
  const auto strides = [](const char* file) {
    return shortest_in_strides(read_maze(content_of(file)).maze.value())->strides;
  };
  EXPECT_EQ(strides("capstone-1-changed.txt"), 14);
  EXPECT_EQ(strides("empty-12.txt"), 4);
  EXPECT_EQ(strides("halls-12.txt"), 8);
  EXPECT_EQ(strides("prim-30.txt"), 19);
}

TEST(BuiltinMazes, TheChangedMazeOneDiffersAsItIsDescribed) {
  const Maze before = read_maze(content_of("capstone-1.txt")).maze.value();
  WallSet open = before.open_walls();
  for (int x = 0; x < 11; ++x) open.insert(wall_at({x, 11}, Heading::east));
  open.erase(wall_at({7, 0}, Heading::north));
  open.erase(wall_at({9, 8}, Heading::north));
  EXPECT_EQ(read_maze(content_of("capstone-1-changed.txt")).maze.value().open_walls(), open);
}

TEST(BuiltinMazes, ManyAreLikeThoseOfContests) {
  int contest = 0;
  std::set<std::string> sizes;
  for (const Row& row : provenance())
    if (row.file.starts_with("contest-")) {
      ++contest;
      sizes.insert(row.size);
    }
  EXPECT_GE(contest, 24);
  EXPECT_TRUE(sizes.contains("12x12") && sizes.contains("32x32"));
}

TEST(BuiltinMazes, TeachWhatTheyAreSaidToTeach) {
  const Maze island = read_maze(content_of("island-8.txt")).maze.value();
  EXPECT_FALSE(wall_follower_arrives(island, Hand::left));
  EXPECT_FALSE(wall_follower_arrives(island, Hand::right));
  EXPECT_EQ(shortest_in_strides(read_maze(content_of("parallel-8.txt")).maze.value())->strides, 6);
  EXPECT_EQ(shortest_in_cells(read_maze(content_of("spiral-9.txt")).maze.value()), 80);
}

}  // namespace
}  // namespace labmouse
