#include "labmouse/lab/studies/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/numbers/maze_interval.hpp"
#include "labmouse/lab/races/race_paths.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/studies/ratios.hpp"
#include "labmouse/maze/symmetry.hpp"
#include "tests/lab/drawing/drawing_samples.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/lab/xml_scanner.hpp"
#include "tests/says.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

/// A hall of so many cells, from one end to the other.
NamedMaze hall(int cells) {
  MazeDraft draft({cells, 1}, MazeDraft::Inside::open);
  draft.add_goal({cells - 1, 0});
  return {"hall-" + std::to_string(cells), Maze(draft)};
}

/// Halls of 2 to 2 + count - 1 cells.
std::vector<NamedMaze> halls(int count) {
  std::vector<NamedMaze> mazes;
  for (int i = 0; i < count; ++i) mazes.push_back(hall(2 + i));
  return mazes;
}

std::vector<NamedMaze> five_mazes() { return {test::loop(), test::corridor(), test::hook(), hall(4), hall(9)}; }

StudyOrder folded(int folds) {
  StudyOrder order;
  order.race = test::in_steps();
  order.folds = folds;
  return order;
}

Study study_of(std::string_view specs, std::vector<NamedMaze> mazes, int folds = 2) {
  return hold_study(test::mice(specs), std::move(mazes), folded(folds));
}

/// A flood that is told of every lesson and, once taught, drives one cell a step.
class Pupil {
 public:
  Contestant contestant() const {
    Contestant mouse = test::mice("flood").front();
    mouse.name = "pupil";
    mouse.taught = [lessons = lessons_](const std::vector<const Maze*>& training, const Rules&,
                                        const std::atomic<bool>*) {
      lessons->push_back(training.size());
      Contestant taught = test::mice("flood:stride=1").front();
      std::vector<Maze> seen;
      for (const Maze* maze : training) seen.push_back(*maze);
      auto& make = std::get<Decider>(taught.kind).make;
      make = [seen, original = make](const Maze& maze, const Briefing& briefing) {
        EXPECT_EQ(std::count(seen.begin(), seen.end(), maze), 0) << "raced where it had learned";
        return original(maze, briefing);
      };
      return taught;
    };
    return mouse;
  }
  const std::vector<std::size_t>& lessons() const { return *lessons_; }

 private:
  /// The number of mazes in each lesson.
  std::shared_ptr<std::vector<std::size_t>> lessons_ = std::make_shared<std::vector<std::size_t>>();
};

TEST(Selection, FoldsMazesTogetherThatAreTurnedOrMirrored) {
  const Maze maze = test::loop().maze;
  const MazeSelection selection = select_mazes({{"b", transformed(maze, {true, 1})},
                                                test::corridor(),
                                                {"a", maze},
                                                {"c", transformed(maze, {true, 0}).with_start({0, 0}, Heading::north)}},
                                               *steps_world());
  EXPECT_THAT(names_of(selection.mazes), ElementsAre("a", "corridor"));
  ASSERT_THAT(selection.duplicates, SizeIs(2));
  EXPECT_EQ(selection.duplicates[0].name, "b");
  EXPECT_EQ(selection.duplicates[1].name, "c");
  EXPECT_EQ(selection.duplicates[1].same_as, "a");
}

TEST(Selection, LeavesOutMazesWithoutARoute) {
  const MazeSelection selection = select_mazes({test::without_route(), test::corridor()}, *steps_world());
  EXPECT_THAT(names_of(selection.mazes), ElementsAre("corridor"));
  EXPECT_THAT(selection.routeless, ElementsAre("without-route"));
  EXPECT_THAT(selection.duplicates, IsEmpty());
}

TEST(Folds, DifferByAtMostOneMaze) {
  std::vector<std::string> names;
  for (int i = 0; i < 23; ++i) names.push_back("maze-" + std::to_string(i));
  const std::vector<int> folds = deal_folds(names, 5, 1);
  std::vector<std::ptrdiff_t> sizes;
  for (int fold = 0; fold < 5; ++fold) sizes.push_back(std::count(folds.begin(), folds.end(), fold));
  EXPECT_THAT(sizes, ElementsAre(5, 5, 5, 4, 4));
}

TEST(Folds, DependOnTheSeedAndOnNamesAlone) {
  const std::vector<std::string> names = {"x/a", "x/b", "x/c", "x/d", "x/e", "x/f"};
  const std::vector<std::string> elsewhere = {"y/z/f", "y/z/e", "y/z/d", "y/z/c", "y/z/b", "y/z/a"};
  std::vector<int> backwards = deal_folds(elsewhere, 3, 1);
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_EQ(deal_folds(names, 3, 1), backwards);
  std::set<std::vector<int>> deals;
  for (std::uint64_t seed = 0; seed < 20; ++seed) deals.insert(deal_folds(names, 3, seed));
  EXPECT_GT(deals.size(), 10U);
}

TEST(Folds, TellMazesOfOneFileNameApartByTheirFolders) {
  const std::vector<int> folds = deal_folds({"one/maze", "two/maze"}, 2, 1),
                         turned = deal_folds({"two/maze", "one/maze"}, 2, 1);
  EXPECT_NE(folds[0], folds[1]);
  EXPECT_EQ(folds[0], turned[1]);
}

TEST(Study, OfMiceThatDoNotLearnFindsWhatARaceFinds) {
  const Study study = study_of("flood,random", five_mazes(), 3);
  const Race race = hold_race(test::mice("flood,random"), five_mazes(), test::in_steps());
  ASSERT_EQ(study.race.results.size(), race.results.size());
  EXPECT_EQ(names_of(study.race.mazes), names_of(race.mazes));
  for (std::size_t i = 0; i < race.results.size(); ++i) {
    const ContestResult &found = study.race.results[i], &expected = race.results[i];
    EXPECT_EQ(found.mouse, expected.mouse);
    EXPECT_EQ(found.maze, expected.maze);
    EXPECT_EQ(found.seed, expected.seed);
    EXPECT_EQ(found.score, expected.score);
  }
  for (std::size_t maze = 0; maze < race.mazes.size(); ++maze)
    EXPECT_EQ(study.race.facts[maze].bound, race.facts[maze].bound);
  EXPECT_EQ(study.folds_done, 3);
  EXPECT_FALSE(study.race.stopped);
}

TEST(Study, TeachesFromTheOtherFoldsOnly) {
  const Pupil pupil;
  const Study study = hold_study({pupil.contestant(), test::mice("flood").front()}, halls(7), folded(3));
  EXPECT_THAT(pupil.lessons(), ElementsAre(4, 5, 5));
  EXPECT_THAT(study.fold_sizes, ElementsAre(3, 2, 2));
  EXPECT_THAT(study.learners, ElementsAre("pupil"));
  EXPECT_THAT(table_of(study, false), Says("Taught", "4 or 5 mazes", ": pupil.\n"));
}

TEST(Study, RacesTheTaughtMouseUnderItsOwnName) {
  // By the name that it has once it was taught, the pupil would stand before the other one.
  const Study study = hold_study({Pupil().contestant(), test::mice("flood:stride=2").front()}, halls(6), folded(2));
  const Race expected = hold_race(test::mice("flood:stride=1,flood:stride=2"), halls(6), test::in_steps());
  ASSERT_NE(scores_by_maze(expected, 0), scores_by_maze(expected, 1));
  EXPECT_EQ(study.race.mice[1].name, "pupil");
  EXPECT_EQ(scores_by_maze(study.race, 1), scores_by_maze(expected, 0));
  EXPECT_EQ(scores_by_maze(study.race, 0), scores_by_maze(expected, 1));
}

TEST(Study, WithoutLearningRacesWhatTheMiceBringAlong) {
  const Pupil pupil;
  StudyOrder order = folded(2);
  order.learning = false;
  const Study study = hold_study({pupil.contestant(), test::mice("flood").front()}, halls(6), order);
  EXPECT_THAT(pupil.lessons(), IsEmpty());
  EXPECT_THAT(comparisons_of(study)[0].pair.differences, Each(0.0));
  EXPECT_THAT(table_of(study, false), Says("Not taught", ": pupil;"));
}

TEST(Study, DependsNeitherOnThreadsNorOnTheOrderOfMazes) {
  std::vector<NamedMaze> backwards = five_mazes();
  std::reverse(backwards.begin(), backwards.end());
  StudyOrder order = folded(2);
  order.race.jobs = 1;
  const Study one = hold_study(test::mice("random,flood"), five_mazes(), order);
  order.race.jobs = 3;
  const Study other = hold_study(test::mice("random,flood"), backwards, order);
  EXPECT_EQ(csv_of(one), csv_of(other));
  // Above stand times, which differ.
  const auto below = [](const std::string& table) { return table.substr(table.find("\ndifference")); };
  EXPECT_EQ(below(table_of(one, false)), below(table_of(other, false)));
  EXPECT_EQ(picture_of(one), picture_of(other));
}

TEST(Study, NeedsTwoFoldsAndAsManyMazes) {
  EXPECT_THAT(study_of("flood", halls(3), 1).error, Says("1 folds", "at least 2"));
  EXPECT_THAT(study_of("flood", {hall(2), hall(3), {"same", hall(3).maze}, test::without_route()}, 3).error,
              Says("2 different mazes", "4 given", "3 folds", "2 folds"));
  EXPECT_THAT(study_of("flood", {hall(2)}, 2).error, Says("1 different maze ", "1 given", "at least 2"));
  EXPECT_THAT(study_of("flood", {}, 2).error, Says("0 different mazes", "0 given", "at least 2"));
  EXPECT_EQ(study_of("flood", halls(3), 3).error, "");
}

/// A study of seven halls in three folds by a flood and a pupil, stopped after so many contests.
Study stopped_after(int contests, const Pupil& pupil) {
  std::atomic<bool> stop = contests == 0;
  int told = 0;
  StudyHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](std::size_t all) {
    EXPECT_EQ(all, 2U * 7U);
    stop = ++told == contests;
  };
  StudyOrder order = folded(3);
  order.race.jobs = 1;
  return hold_study({pupil.contestant(), test::mice("flood").front()}, halls(7), order, hooks);
}

TEST(Study, ThatIsStoppedKeepsWholeFolds) {
  const Pupil pupil;
  const Study study = stopped_after(2 * 3 + 1, pupil);
  EXPECT_EQ(study.folds_done, 1);
  EXPECT_TRUE(study.race.stopped);
  EXPECT_THAT(study.race.mazes, SizeIs(3));
  EXPECT_THAT(study.fold_of, ElementsAre(0, 0, 0));
  EXPECT_THAT(study.race.results, SizeIs(2 * 3));
  EXPECT_THAT(pupil.lessons(), SizeIs(2));
  EXPECT_THAT(table_of(study, false), Says("Stopped", "1 of 3 folds", "3 of 7 mazes"));
  EXPECT_THAT(picture_of(study), HasSubstr(", stopped early: 3 mazes in 1 fold<"));
}

TEST(Study, ThatIsStoppedAtOnceSaysSo) {
  const Pupil pupil;
  const Study study = stopped_after(0, pupil);
  EXPECT_THAT(pupil.lessons(), IsEmpty());
  EXPECT_THAT(table_of(study, false), Says("Stopped", "0 of 3 folds", "0 of 7 mazes"));
  EXPECT_EQ(csv_of(study), "maze,fold,bound,pupil,flood\n");
  EXPECT_EQ(XmlScanner(picture_of(study)).complaint(), "");
  const auto json = nlohmann::json::parse(json_of(study, {}));
  EXPECT_EQ(json["stopped"], true);
  EXPECT_TRUE(json["comparisons"][0]["mean_difference"].is_null());
}

TEST(Study, ThatIsStoppedWhileItTeachesTeachesNoOther) {
  std::atomic<bool> stop = false;
  const Pupil pupil;
  Contestant first = pupil.contestant(), second = pupil.contestant();
  second.name = "second";
  first.taught = [&, teach = first.taught](const std::vector<const Maze*>& training, const Rules& rules,
                                           const std::atomic<bool>* heard) {
    EXPECT_EQ(heard, &stop);
    stop = true;
    return teach(training, rules, heard);
  };
  StudyHooks hooks;
  hooks.stop = &stop;
  const Study study = hold_study({first, second}, halls(4), folded(2), hooks);
  EXPECT_TRUE(study.race.stopped);
  EXPECT_EQ(study.folds_done, 0);
  EXPECT_THAT(pupil.lessons(), SizeIs(1));
}

std::vector<std::string> pairs_of(const Study& study) {
  std::vector<std::string> pairs;
  for (const Comparison& comparison : comparisons_of(study))
    pairs.push_back(study.race.mice[comparison.mouse].name + "-" + study.race.mice[comparison.against].name);
  return pairs;
}

TEST(Comparisons, AreOfEachPairOrWithTheFirst) {
  EXPECT_THAT(pairs_of(study_of("flood", halls(2))), IsEmpty());
  EXPECT_THAT(pairs_of(study_of("flood,certify,random", halls(2))),
              ElementsAre("certify-flood", "random-flood", "random-certify"));
  EXPECT_THAT(pairs_of(study_of("flood,certify,random,frontier", halls(2))), SizeIs(6));
  const Study many = study_of("flood,certify,random,frontier,cautious", halls(2));
  EXPECT_THAT(pairs_of(many), ElementsAre("certify-flood", "random-flood", "frontier-flood", "cautious-flood"));
  EXPECT_THAT(table_of(many, false), HasSubstr("only with the first"));
}

TEST(Comparisons, AreOfScoresMazeByMaze) {
  const Study study = study_of("flood,flood:stride=1", five_mazes());
  const Comparison comparison = comparisons_of(study).front();
  const auto first = scores_by_maze(study.race, comparison.mouse),
             second = scores_by_maze(study.race, comparison.against);
  ASSERT_THAT(comparison.pair.differences, SizeIs(5));
  for (std::size_t maze = 0; maze < 5; ++maze)
    EXPECT_EQ(comparison.pair.differences[maze], *first[maze] - *second[maze]);
  EXPECT_EQ(comparison.pair.scores.below + comparison.pair.scores.equal + comparison.pair.scores.above, 5);
  EXPECT_GT(comparison.pair.scores.above, 2);
  EXPECT_EQ(comparison.pair.scores.interval, mean_interval(comparison.pair.differences, 1));
}

std::vector<std::string> figures_of(const std::vector<FigureRatio>& ratios) {
  std::vector<std::string> figures;
  for (const FigureRatio& ratio : ratios) figures.emplace_back(ratio.figure);
  return figures;
}

TEST(Ratios, InStepsAreOfScores) {
  const Study study = study_of("flood,flood:stride=1", five_mazes());
  const auto ratios = ratios_of(study, comparisons_of(study).front());
  ASSERT_THAT(figures_of(ratios), ElementsAre("score"));
  const std::vector<Standing> standings = standings_of(study.race);
  EXPECT_EQ(ratios[0].mazes, 5);
  EXPECT_DOUBLE_EQ(ratios[0].found.ratio, *standings[1].mean_all / *standings[0].mean_all);
  EXPECT_GT(standings[1].mean_all, standings[0].mean_all);
}

/// Two mice under the rules of that name, in mazes in which they score and that take some time.
Study in_seconds(std::string_view specs, const std::string& rules, int mazes) {
  StudyOrder order = folded(2);
  order.race.world = seconds_world(find_rules(rules).rules, test::drive_model("mm2021"));
  std::vector<NamedMaze> some;
  for (Rng rng(5); std::ssize(some) < mazes;) {
    Maze maze = test::any_maze(rng, 6);
    maze = maze.with_start({0, 0}, Heading::north).with_goals(centre_of(maze.size()));
    const NamedMaze named = {"maze-" + std::to_string(some.size()), maze};
    if (!maze.is_goal(maze.start()) && select_mazes({named}, *order.race.world).mazes.size() == 1)
      some.push_back(named);
  }
  return hold_study(test::mice(specs), std::move(some), order);
}

TEST(Ratios, InSecondsAreOfTimesToo) {
  const Study study = in_seconds("flood,certify", "thirtieth", 9);
  const Comparison comparison = comparisons_of(study).front();
  const auto ratios = ratios_of(study, comparison);
  ASSERT_THAT(figures_of(ratios), ElementsAre("score", "search", "best run"));
  const std::vector<Standing> standings = standings_of(study.race);
  const auto mean = [&](std::size_t mouse, std::string_view key) {
    const auto standing =
        std::find_if(standings.begin(), standings.end(), [&](const Standing& s) { return s.mouse == mouse; });
    return *number_of(figure_of(study.race, *standing, key));
  };
  EXPECT_NEAR(ratios[1].found.ratio, mean(comparison.mouse, "mean_search") / mean(comparison.against, "mean_search"),
              1e-9);
  EXPECT_NEAR(ratios[2].found.ratio, mean(comparison.mouse, "mean_best") / mean(comparison.against, "mean_best"), 1e-9);
  EXPECT_GT(ratios[1].found.ratio, 1.0);
  EXPECT_LE(ratios[2].found.ratio, 1.0);
}

TEST(Ratios, CountMazesInWhichBothHaveTheFigure) {
  Study study = in_seconds("flood,certify", "all-japan", 6);
  const Comparison comparison = comparisons_of(study).front();
  for (ContestResult& contest : study.race.results)
    if (contest.mouse == comparison.mouse && contest.maze == 0) {
      contest.score.reset();
      contest.counted.reset();
    }
  for (const FigureRatio& ratio : ratios_of(study, comparison)) EXPECT_EQ(ratio.mazes, 5) << ratio.figure;
  for (ContestResult& contest : study.race.results)
    if (contest.maze == 1) contest.counted = -2.0;
  EXPECT_THAT(figures_of(ratios_of(study, comparison)), ElementsAre("search", "best run"));
}

/// Made up: two mice of which one failed once, and names that trouble readers.
Study made_up() {
  Study study = study_of("flood,flood:stride=1", {{"a<b>,&\"c\"\x1b", hall(4).maze}, hall(7)});
  for (ContestResult& contest : study.race.results)
    if (contest.mouse == 1 && contest.maze == 1) {
      contest.score.reset();
      contest.counted = 100;
      contest.outcome = "out of steps";
    }
  study.selection.duplicates.assign(12, {"twin", "hall-4"});
  return study;
}

TEST(StudyAsTable, HasStandingsDifferencesAndNotes) {
  const std::string table = table_of(made_up(), false);
  EXPECT_THAT(table, Says("2 mice", "2 mazes", "2 folds", "seed 1\n"));
  EXPECT_THAT(table, HasSubstr(leaderboard_of(made_up().race, false).substr(0, 150)));
  EXPECT_THAT(table, HasSubstr("\nflood               2/2   1.583     0.0-8.1   1.000    2.5      0.00\n"));
  EXPECT_THAT(table, HasSubstr("\nflood:stride=1      1/2  50.567   0.0-678.7   1.062    4.0      0.00\n"));
  EXPECT_THAT(table,
              Says("+48.983", "-572.562 to +670.529", "0     0      2  0.500", "too few mazes", "8 mazes", "Add 6"));
  EXPECT_THAT(table, HasSubstr("\nflood:stride=1 / flood 31.937 [0.000, 296.220]\n"));
  EXPECT_THAT(table, Says("12 duplicates", ":\n  twin = hall-4\n", "  ... and 2 more", "--format json"));
  EXPECT_THAT(table, Says("None of these mice", "learns"));
  EXPECT_THAT(table, Not(HasSubstr("Stopped")));
  EXPECT_THAT(table, Not(HasSubstr("\x1b")));
  EXPECT_THAT(table_of(made_up(), true), HasSubstr("\x1b[1m"));
}

TEST(StudyAsTable, OfOneMouseHasStandingsOnly) {
  const std::string table = table_of(study_of("flood", halls(2)), false);
  EXPECT_THAT(table, HasSubstr("\nflood "));
  EXPECT_THAT(table, Not(HasSubstr("difference")));
}

TEST(StudyAsCsv, HasALineForEachMaze) {
  const std::string csv = csv_of(made_up());
  EXPECT_THAT(csv, HasSubstr("maze,fold,bound,flood,flood:stride=1\n\"a<b>,&\"\"c\"\"\x1b\","));
  EXPECT_THAT(csv, HasSubstr(",100\n"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

TEST(StudyAsCsv, NamesTheMiceInTheirOrder) {
  EXPECT_THAT(csv_of(study_of("flood:stride=1,flood", {hall(2), hall(4)})),
              HasSubstr("\nhall-4,1,1.0666666666666667,1.1333333333333333,1.0666666666666667\n"));
}

TEST(StudyAsJson, HasAllThatTheRaceHasAndMore) {
  const auto json = nlohmann::json::parse(json_of(made_up(), {{"bad.txt", {}}}));
  EXPECT_EQ(json["groups"][0]["mazes"].size(), 2U);
  EXPECT_EQ(json["groups"][0]["mazes"][0]["fold"].get<int>() + json["groups"][0]["mazes"][1]["fold"].get<int>(), 1 + 2);
  EXPECT_EQ(json["folds"].size(), 2U);
  EXPECT_EQ(json["folds"][0]["training"], 1);
  EXPECT_EQ(json["groups"][0]["mice"][0]["results"].size(), 2U);
  EXPECT_EQ(json["comparisons"][0]["mouse"], "flood:stride=1");
  EXPECT_EQ(json["comparisons"][0]["against"], "flood");
  EXPECT_EQ(json["comparisons"][0]["losses"], 2);
  EXPECT_EQ(json["comparisons"][0]["sign_test"], 0.5);
  const auto& ratio = json["comparisons"][0]["ratios"][0];
  EXPECT_EQ(ratio["figure"], "score");
  EXPECT_EQ(ratio["mazes"], 2);
  EXPECT_NEAR(ratio["ratio"].get<double>(), 31.937, 0.001);
  EXPECT_LT(ratio["interval"][0], ratio["interval"][1]);
  EXPECT_EQ(json["duplicates"].size(), 12U);
  EXPECT_EQ(json["skipped"][0]["path"], "bad.txt");
}

TEST(StudyAsPicture, ShowsEachMazeOnceADifferenceAndOnceAScore) {
  const std::string svg = picture_of(made_up());
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  EXPECT_EQ(count(svg, "<circle"), 2 * 2 + 2);    // and two in the legend
  EXPECT_EQ(count(svg, "<rect"), 2 + 2 + 2 + 1);  // bars; their samples; the interval and its sample; the ground
  EXPECT_THAT(svg, HasSubstr("hall-7 (fold "));
  EXPECT_THAT(svg, HasSubstr(": 100.000 - 2.100 = +97.900</title>"));
  EXPECT_THAT(svg, HasSubstr(">flood better in 2 mazes<"));
  EXPECT_THAT(svg, HasSubstr(">flood:stride=1 - flood (steps)<"));
  EXPECT_THAT(svg, HasSubstr(">bound of the maze (steps)<"));
  EXPECT_THAT(svg, HasSubstr(">95 % interval of the mean, -572.562 to +670.529<"));
  EXPECT_THAT(svg, HasSubstr("<title>Study of flood, flood:stride=1: 2 mazes in 2 folds</title>"));
  EXPECT_THAT(svg, HasSubstr("@media (prefers-color-scheme:dark)"));
}

/// The differences that bars of that colour say, in their order.
std::vector<double> bars(const std::string& svg, const std::string& tone) {
  const auto begin = svg.find("<g class=\"fill-" + tone + "\""), end = svg.find("</g>", begin);
  std::vector<double> differences;
  for (auto at = svg.find(" = ", begin); at < end; at = svg.find(" = ", at + 1))
    differences.push_back(std::stod(svg.substr(at + 3)));
  return differences;
}

TEST(StudyAsPicture, HasTheFirstMousesWinsInOrderOnTheLeft) {
  const Study study = study_of("flood,flood:stride=1", load_builtin_mazes().mazes);
  const std::string svg = picture_of(study);
  const std::vector<double> wins = bars(svg, "to-goal"), losses = bars(svg, "route");
  EXPECT_THAT(wins, SizeIs(static_cast<std::size_t>(comparisons_of(study)[0].pair.scores.below)));
  EXPECT_THAT(wins, Each(::testing::Lt(0.0)));
  EXPECT_THAT(losses, Each(::testing::Ge(0.0)));
  EXPECT_TRUE(std::is_sorted(wins.begin(), wins.end()) && std::is_sorted(losses.begin(), losses.end()));
  EXPECT_EQ(wins.size() + losses.size(), study.race.mazes.size());
}

TEST(StudyAsPicture, OfOneMouseShowsItsScores) {
  const std::string svg = picture_of(study_of("flood", halls(4)));
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  EXPECT_EQ(count(svg, "<circle"), 4 + 1);
  EXPECT_EQ(count(svg, "<rect"), 1);
}

TEST(StudyAsPicture, HasARowForEachComparison) {
  const std::string svg = picture_of(study_of("flood,flood:stride=1,flood:stride=2", halls(4)));
  EXPECT_EQ(count(svg, "against flood"), 3);
  EXPECT_EQ(count(svg, ">bound of the maze (steps)<"), 3);
}

}  // namespace
}  // namespace labmouse
