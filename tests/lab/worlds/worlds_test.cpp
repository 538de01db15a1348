// All that can be done with a world, in each world there is.
#include "labmouse/lab/worlds/worlds.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <nlohmann/json.hpp>

#include "labmouse/lab/page/calls.hpp"
#include "labmouse/lab/races/earlier_results.hpp"
#include "labmouse/lab/reports/report_page.hpp"
#include "labmouse/lab/result_folders/race_folder.hpp"
#include "labmouse/lab/standings/baseline.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "labmouse/mouse/forwarding_strategy.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/lab/mms/mms_fixture.hpp"
#include "tests/lab/reports/unpacking.hpp"
#include "tests/lab/xml_scanner.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using test::Says;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

const std::string program = "mms:\"" LABMOUSE_MMS_PROGRAM "\"";

/// What to try in a world: two mice, another setting that its results depend on, and a parameter of a mouse.
struct Trial {
  std::vector<std::string> mice;
  WorldSettings other;
  std::string swept, variation;
};

const Trial& trial_of(const WorldEntry& entry) {
  static const std::map<std::string_view, Trial> trials = {
      {"steps", {{"flood,random"}, {{"budget", "40"}}, "flood", "stride=1,2,02"}},
      {"seconds", {{"flood,ariadne"}, {{"rules", "thirtieth"}}, "ariadne", "prior=contest,uniform,contest"}},
      {"physical", {{"flood,ariadne"}, {{"noise", "2"}}, "ariadne", "prior=contest,uniform,contest"}},
      {"failures", {{"flood,ariadne"}, {{"variation", "1.2"}}, "ariadne", "prior=contest,uniform,contest"}},
      {"mms",
       {{program + " ask:turnRight ask:moveForward", program + " ask:turnLeft exit:2"},
        {{"presses", "3"}},
        program + " burst:{turns}:turnLeft hear:{turns} ask:turnRight ask:moveForward",
        "turns=0,4,0"}}};
  return trials.at(entry.name);
}

/// In one of them no mouse can score.
std::vector<NamedMaze> mazes() { return {test::loop(), test::plank(), test::corridor(), test::shaft()}; }

ExternalOptions patient() {
  ExternalOptions options;
  options.limits.silence = std::chrono::seconds(20);  // on a busy machine
  return options;
}

/// All of a race but what differs from one time to the next.
std::string digest(const Race& race) {
  std::string text;
  for (const ContestResult& result : race.results) {
    text += race.mice[result.mouse].name + ' ' + text_of(value_of(result.counted));
    for (const ContestField& field : race.world().traits().fields->contest)
      if (!field.by_clock) text += ' ' + text_of(field.of(race, result));
    text += '\n';
  }
  return text;
}

class AWorld : public testing::TestWithParam<const WorldEntry*> {
 protected:
  RaceOrder order(int jobs = 0, const WorldSettings& settings = {}) const {
    return {GetParam()->make(settings).world, 2, 1, jobs};
  }
  const Trial& trial() const { return trial_of(*GetParam()); }
  std::vector<Contestant> mice() const { return read_specs(trial().mice, patient()).contestants; }
  Race race(int jobs = 0) const { return hold_race(mice(), mazes(), order(jobs)); }
  /// What the JSON of a race has of its only world.
  static Json part_of(const std::string& json) { return Json::parse(json).at("groups").at(0); }
};

INSTANTIATE_TEST_SUITE_P(All, AWorld, testing::ValuesIn(all_worlds().begin(), all_worlds().end()),
                         [](const auto& world) { return std::string(world.param->name); });

TEST_P(AWorld, IsFoundByItsName) {
  EXPECT_EQ(find_world(GetParam()->name), GetParam());
  EXPECT_EQ(default_world(GetParam()->name)->traits().name, GetParam()->name);
  for (const Contestant& mouse : mice()) EXPECT_EQ(order().world->refuse(mouse), "");
}

TEST_P(AWorld, ListsAFigureForEachField) {
  const Race held = race();
  const WorldFields& fields = *held.world().traits().fields;
  for (const ContestResult& result : held.results)
    for (const auto& list : {fields.contest, fields.csv})
      for (const ContestField& field : list) EXPECT_NO_THROW(field.of(held, result)) << field.key;
}

TEST_P(AWorld, HasResultsThatDoNotDependOnThreadsOrOrder) {
  const std::string alone = digest(race(1));
  EXPECT_EQ(digest(race(4)), alone);
  std::vector<Contestant> backwards = mice();
  std::reverse(backwards.begin(), backwards.end());
  std::vector<NamedMaze> turned = mazes();
  std::reverse(turned.begin(), turned.end());
  const Race other = hold_race(backwards, turned, order());
  EXPECT_EQ(digest(other), alone);
  EXPECT_EQ(contests_of(other.mice, other.mazes.size(), other.order), other.results.size());
}

TEST_P(AWorld, HasResultsOfAMouseThatDoNotDependOnTheOthers) {
  const Race held = race();
  EXPECT_THAT(digest(held), HasSubstr(digest(hold_race({held.mice[1]}, mazes(), order()))));
}

/// A program that knows no world by its name finds scores and best possible scores where the JSON says.
TEST_P(AWorld, SaysInJsonWhereItsScoresAndBoundsAre) {
  const Race held = race();
  const Json group = part_of(json_of(held, {}));
  const Json &score = group.at("score"), &bound = group.at("bound");
  std::vector<std::size_t> next(held.mice.size());
  int scores = 0;
  for (const ContestResult& contest : held.results) {
    const std::size_t index = next[contest.mouse]++;
    if (!contest.score) continue;
    const auto mouse = std::ranges::find(group.at("mice"), Json(held.mice[contest.mouse].name),
                                         [](const Json& one) { return one.at("name"); });
    const Json& result = mouse->at("results").at(index);
    const Json& whole = result.at(score.at("key").get<std::string>());
    const Json& value = score.at("inner") == "" ? whole : whole.at(score.at("inner").get<std::string>());
    EXPECT_NEAR(value.get<double>() * score.at("unit").get<double>(), *contest.score, 1e-9);
    const Json& best = group.at("mazes").at(contest.maze).at(bound.at("key").get<std::string>());
    EXPECT_NEAR(best.get<double>() * bound.at("unit").get<double>(), held.facts[contest.maze].bound.value(), 1e-9);
    ++scores;
  }
  EXPECT_GT(scores, 0);
}

TEST_P(AWorld, HasStandingsBestFirst) {
  const Race held = race();
  const std::vector<Standing> standings = standings_of(held);
  ASSERT_THAT(standings, SizeIs(2));
  EXPECT_LE(*standings[0].mean_all, *standings[1].mean_all);
  for (const Standing& standing : standings) {
    const int runs = standing.runs / static_cast<int>(mazes().size() - 1);  // the shaft does not count
    EXPECT_EQ(standing.runs, runs * 3);
    EXPECT_LE(standing.interval.low, *standing.mean_all);
    EXPECT_GE(standing.interval.high, *standing.mean_all);
    EXPECT_EQ(figure_of(held, standing, "runs"), Value(standing.runs));
    std::vector<double> shares;
    for (const ContestResult& contest : held.results)
      if (contest.mouse == standing.mouse && counts(held, contest) &&
          contest.score.has_value() == contest.ratio.has_value())
        shares.push_back(contest.score ? std::min(1.0, 1.0 / *contest.ratio) : 0.0);
    EXPECT_NEAR(*standing.mean_share, mean_if_any(shares).value(), 1e-12);
    EXPECT_LE(0.0, standing.share.low);
    EXPECT_LE(standing.share.low, *standing.mean_share);
    EXPECT_LE(*standing.mean_share, standing.share.high);
    EXPECT_LE(standing.share.high, 1.0);
  }
  EXPECT_GT(standings[0].finished, 0);
  EXPECT_GE(*standings[0].mean_ratio, 1.0 - 1e-9);
}

TEST_P(AWorld, HasATable) {
  const Race held = race();
  const std::string table = table_of(held, false);
  const std::string all = table_of(held, false, true);
  for (const Column& column : held.world().traits().fields->columns) {
    EXPECT_THAT(all, HasSubstr(std::string(column.second)));
    if (!column.rare) {
      EXPECT_THAT(table, HasSubstr(std::string(column.second)));
    }
  }
  EXPECT_LT(table.size(), all.size());
  EXPECT_THAT(table, AllOf(Says("Left out", "1 maze", "(shaft)"), Not(HasSubstr("Stopped")), Not(HasSubstr("\x1b"))));
  EXPECT_THAT(table_of(held, true), HasSubstr("\x1b[1m"));
}

TEST_P(AWorld, HasJsonWithAllItsFields) {
  const Race held = race();
  const Json json = part_of(json_of(held, {}));
  for (const Condition& condition : held.world().traits().conditions) EXPECT_TRUE(json.contains(condition.key));
  ASSERT_THAT(json.at("mazes"), SizeIs(mazes().size()));
  for (const MazeField& field : held.world().traits().fields->maze)
    EXPECT_TRUE(json["mazes"][0].contains(std::string(field.key))) << field.key;
  ASSERT_THAT(json.at("mice"), SizeIs(2));
  std::size_t results = 0;
  for (const Json& mouse : json["mice"]) {
    for (const MouseField& field : held.world().traits().fields->mouse)
      EXPECT_TRUE(mouse.contains(std::string(field.key))) << field.key;
    results += mouse.at("results").size();
  }
  EXPECT_EQ(results, held.results.size());
}

TEST_P(AWorld, HasCsvOfALineAContest) {
  const Race held = race();
  const std::string csv = csv_of(held);
  const auto lines = static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n'));
  EXPECT_EQ(lines, 1 + held.results.size());
  const auto commas = static_cast<std::size_t>(std::count(csv.begin(), csv.end(), ','));
  EXPECT_EQ(commas, lines * (held.world().traits().fields->csv.size() - 1));
  EXPECT_THAT(csv, StartsWith("mouse,maze,"));
}

TEST_P(AWorld, ComparesARaceWithAnEarlierOne) {
  const Race held = race();
  const auto compared = [&](const Race& now) {
    const ReadBaselineResult read = read_baseline(json_of(held, {}), now.world());
    EXPECT_EQ(read.error, "");
    return read.baseline ? compare_with_baseline(now, *read.baseline) : "";
  };
  const std::string same = compared(held);
  for (const Contestant& mouse : held.mice) EXPECT_THAT(same, HasSubstr(mouse.name + ": +0.000 [+0.000, +0.000] over"));
  EXPECT_THAT(same, Not(HasSubstr("Warning")));
  const Race other = hold_race(mice(), mazes(), order(0, trial().other));
  EXPECT_THAT(compared(other), HasSubstr("Warning: " + trial().other.begin()->first));
  for (const WorldEntry* entry : all_worlds()) {
    const std::string error = read_baseline(json_of(held, {}), *entry->make({}).world).error;
    if (entry == GetParam())
      EXPECT_EQ(error, "");
    else
      EXPECT_THAT(error, Says("no race", entry->name));
  }
}

TEST_P(AWorld, ListsTheWorstMazesAndTheShares) {
  const Race held = race();
  const std::string worst = worst_of(held, 1), shares = shares_of(held);
  EXPECT_THAT(worst, Not(HasSubstr("shaft")));
  for (const Contestant& mouse : held.mice) EXPECT_THAT(worst, HasSubstr(mouse.name + ": worst mazes\n"));
  const Standing best = standings_of(held).front();
  const double visited = *number_of(figure_of(held, best, "mean_visited_share"));
  EXPECT_GT(visited, 0.0);
  EXPECT_LE(visited, 1.0);
  EXPECT_THAT(shares, HasSubstr(fmt::format(" {:.1f}\n", 100.0 * visited)));
}

constexpr const char* page = "<html><body><!-- labmouse:report --></body></html>";

TEST_P(AWorld, LeavesRecordsAndPicturesForAReport) {
  if (GetParam()->name == "failures") LABMOUSE_SKIP_SANITIZED();  // the physical world does the same and more
  const test::AFolder folder;
  std::optional<RaceFolder> kept;
  RaceHooks hooks;
  hooks.keep = RaceFolder::keep;
  hooks.finished = [&](const Race& race, const ContestResult& contest, const ContestOutput& held) {
    if (!kept) kept.emplace(folder.path(), race);
    EXPECT_EQ(held.picture.empty(), contest.run > 0);
    EXPECT_EQ(kept->save(contest, held), "");
  };
  const Race held = hold_race(mice(), mazes(), order(), hooks);
  const RacePaths paths(folder.path(), names_of(held.mice), names_of(held.mazes), held.world().traits().numbers_runs);
  for (const ContestResult& result : held.results) {
    EXPECT_NE(read_file(paths.record(result.mouse, result.maze, result.run)).content, "");
    const std::string picture = read_file(paths.picture(result.mouse, result.maze)).content;
    EXPECT_EQ(XmlScanner(picture).complaint(), "");
    EXPECT_THAT(picture, HasSubstr("<svg"));
  }
  EXPECT_EQ(write_file(folder.path() + "/" + results_file_name, json_of(held, {})), "");
  const ReportPage report = make_report(folder.path(), page);
  EXPECT_EQ(report.error, "");
  EXPECT_THAT(report.notes, IsEmpty());
  EXPECT_THAT(test::block_of(report.page, "labmouse-records")["records"], SizeIs(2 * mazes().size()));
}

TEST_P(AWorld, HasRecordsThatAreOpenedAndShown) {
  if (GetParam()->name == "failures") LABMOUSE_SKIP_SANITIZED();  // the physical world does the same and more
  int drawings = 0;
  RaceHooks hooks;
  hooks.keep = [](const ContestResult&) { return Keep{.record = true, .picture = true}; };
  hooks.finished = [&](const Race& race, const ContestResult& contest, const ContestOutput& held) {
    const RecordKind& kind = kind_of_record(held.record);
    EXPECT_EQ(&kind, GetParam()->records);
    const OpenedRecord opened = kind.open(held.record, nullptr);
    ASSERT_NE(opened.replay, nullptr) << opened.disagreement;
    const Replay& replay = *opened.replay;
    const NamedMaze& maze = race.mazes[contest.maze];
    EXPECT_EQ(replay.subject().mouse, race.mice[contest.mouse].name);
    EXPECT_EQ(replay.subject().maze.maze.open_walls(), maze.maze.open_walls());
    EXPECT_EQ(replay.picture(), held.picture);
    EXPECT_THAT(replay.summary(text_drawer(false)), testing::EndsWith(replay.result()));
    // Of one contest: some have thousands of moves.
    if (drawings == 0)
      replay.animate(text_drawer(false), [&](const std::string& drawing) { drawings += drawing.empty() ? 0 : 1; });
    const RecordDrawing drawing = replay.drawing(replay.layers(), 0);
    EXPECT_EQ(drawing.error, "");
    EXPECT_EQ(drawing.line, replay.result());
    // A report carries it in another form, of which the same is shown.
    const ReadJson packed = ReadJson::parse(replay.packed().dump());
    EXPECT_EQ(&kind_of_packed(packed), &kind);
    const OpenedRecord unpacked = kind.unpack(packed, maze);
    ASSERT_NE(unpacked.replay, nullptr) << unpacked.disagreement;
    EXPECT_EQ(unpacked.replay->result(), replay.result());
    EXPECT_EQ(unpacked.replay->play()["x"], replay.play()["x"]);
  };
  hold_race(mice(), {test::loop(), test::corridor()}, order(), hooks);
  EXPECT_GT(drawings, 0);
}

TEST_P(AWorld, ReadsRecordsWithFormerNames) {
  if (GetParam()->name == "failures") LABMOUSE_SKIP_SANITIZED();  // the physical world does the same and more
  RaceHooks hooks;
  hooks.keep = [](const ContestResult&) { return Keep{.record = true}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) {
    std::string former;
    for (std::size_t begin = 0, end = 0; (end = held.record.find('\n', begin)) != std::string::npos; begin = end + 1)
      former += one_line(with_names(read_ordered_json(std::string_view(held.record).substr(begin, end - begin)),
                                    former_key, former_value)) +
                "\n";
    const OpenedRecord today = GetParam()->records->open(held.record, nullptr);
    const OpenedRecord opened = GetParam()->records->open(former, nullptr);
    ASSERT_NE(opened.replay, nullptr) << opened.disagreement << testing::PrintToString(opened.problems.size())
                                      << former;
    EXPECT_EQ(opened.replay->result(), today.replay->result());
  };
  hold_race(mice(), {test::loop()}, order(), hooks);
}

TEST_P(AWorld, ReadsResultsWithFormerNames) {
  const Json today = read_ordered_json(json_of(race(), {}));
  EXPECT_EQ(with_groups(with_names(today, former_key, former_value)).dump(1), today.dump(1));
}

TEST_P(AWorld, HasRecordsThatDoNotFitEveryMaze) {
  if (GetParam()->name == "failures") LABMOUSE_SKIP_SANITIZED();  // the physical world does the same and more
  RaceHooks hooks;
  hooks.keep = [](const ContestResult&) { return Keep{.record = true}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) {
    const RecordKind& kind = *GetParam()->records;
    const NamedMaze other = test::hook();
    const OpenedRecord opened = kind.open(held.record, &other);
    EXPECT_EQ(opened.replay, nullptr);
    EXPECT_NE(opened.disagreement, "");
    EXPECT_FALSE(kind.open("{\"labmouse\":\"" + std::string(kind.header) + "\"}", nullptr).problems.empty());
  };
  hold_race(mice(), {test::loop()}, order(), hooks);
}

TEST_P(AWorld, IsOpenedByThePage) {
  const std::string text = json_of(race(), {});
  const Json reply = Json::parse(answer_page("open", R"({"name": "race.json"})", text).json);
  ASSERT_TRUE(reply.contains("answer")) << reply.dump();
  const Json opened = part_of(reply.at("answer").at("results").dump()), written = part_of(text);
  EXPECT_EQ(opened.at("mazes"), written.at("mazes"));
  ASSERT_THAT(opened.at("mice"), SizeIs(written.at("mice").size()));
  for (std::size_t mouse = 0; mouse < opened.at("mice").size(); ++mouse)
    for (const char* key : {"name", "runs", "mean_score", "interval", "mean_ratio"})
      EXPECT_EQ(opened.at("mice").at(mouse).at(key), written.at("mice").at(mouse).at(key)) << key;
  EXPECT_EQ(opened.at("mice").at(0).at("results").at(0).at("score"),
            written.at("mice").at(0).at("results").at(0).at("score"));
}

TEST_P(AWorld, KeepsNothingThatIsNotAskedFor) {
  int told = 0;
  RaceHooks hooks;
  hooks.finished = [&](const Race&, const ContestResult& contest, const ContestOutput& held) {
    ++told;
    EXPECT_TRUE(contest.done);
    EXPECT_EQ(held.record + held.picture, "");
  };
  const Race held = hold_race(mice(), mazes(), order(), hooks);
  EXPECT_EQ(told, static_cast<int>(held.results.size()));
}

TEST_P(AWorld, IsLeftHalfDoneWhereItIsStopped) {
  std::atomic<bool> stop = false;
  RaceHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput&) { stop = true; };
  const Race held = hold_race(mice(), mazes(), order(1), hooks);
  EXPECT_TRUE(held.stopped);
  EXPECT_EQ(std::count_if(held.results.begin(), held.results.end(), [](const auto& r) { return r.done; }), 1);
  EXPECT_THAT(table_of(held, false), Says("Stopped", fmt::format("1 of {} contests", held.results.size())));
  const std::string csv = csv_of(held);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
  const Json json = part_of(json_of(held, {}));
  EXPECT_EQ(json.at("stopped"), true);
  EXPECT_EQ(json["mice"][0]["results"].size() + json["mice"][1]["results"].size(), 1U);
}

TEST_P(AWorld, KnowsNothingWhereItIsStoppedAtOnce) {
  const std::atomic<bool> stop = true;
  RaceHooks hooks;
  hooks.stop = &stop;
  const Race held = hold_race(mice(), mazes(), order(), hooks);
  EXPECT_TRUE(held.stopped);
  for (const MazeFacts& facts : held.facts) EXPECT_FALSE(facts.found);
  const std::string table = table_of(held, false);
  EXPECT_THAT(table, Says("Stopped", fmt::format("0 of {} contests", held.results.size())));
  EXPECT_THAT(table, Not(HasSubstr(std::string(held.world().traits().why_no_bound))));
  EXPECT_THAT(part_of(json_of(held, {})).at("mazes"), SizeIs(mazes().size()));
}

/// Does what another strategy does, and stops its race with a decision.
template <class Forwarder, class Kind>
class Stopper final : public Forwarder {
 public:
  Stopper(std::unique_ptr<Kind> mouse, int last, std::atomic<bool>& stop, std::atomic<int>& decisions)
      : Forwarder(*mouse), mouse_(std::move(mouse)), last_(last), stop_(stop), decisions_(decisions) {}

  Action decide(const Sighting& seen) override {
    if (++decisions_ == last_) stop_ = true;
    return mouse_->decide(seen);
  }

 private:
  std::unique_ptr<Kind> mouse_;
  int last_;
  std::atomic<bool>& stop_;
  std::atomic<int>& decisions_;
};

TEST_P(AWorld, AsksAMouseForNothingOnceItIsStopped) {
  if (GetParam()->name == "mms") return;  // there mice are programs, which are ended
  std::atomic<bool> stop = false;
  std::atomic<int> decisions = 0;
  Contestant mouse = test::mice("flood").front();
  auto& [make, drive] = std::get<Decider>(mouse.kind);
  make = [&, original = make](const Maze& maze, const Briefing& briefing) {
    return std::make_unique<Stopper<ForwardingStrategy, Strategy>>(original(maze, briefing), 3, stop, decisions);
  };
  drive = [&, original = drive](const Maze& maze, const Briefing& briefing) {
    return std::make_unique<Stopper<ForwardingDriver, DrivingStrategy>>(original(maze, briefing), 3, stop, decisions);
  };
  RaceHooks hooks;
  hooks.stop = &stop;
  const Race held = hold_race({mouse}, {test::loop()}, order(1), hooks);
  EXPECT_EQ(decisions, 3);
  EXPECT_TRUE(held.stopped);
  EXPECT_FALSE(held.results.front().done);
}

TEST_P(AWorld, HasStudies) {
  StudyOrder order;
  order.race = this->order();
  order.folds = 3;
  const Study study = hold_study(mice(), mazes(), order);
  ASSERT_EQ(study.error, "");
  EXPECT_THAT(study.selection.routeless, ElementsAre("shaft"));
  EXPECT_EQ(digest(study.race), digest(hold_race(mice(), {test::loop(), test::plank(), test::corridor()}, order.race)));
  EXPECT_THAT(comparisons_of(study), SizeIs(1));
  EXPECT_THAT(table_of(study, false), HasSubstr("Score: " + order.race.world->traits().formula));
  const std::string csv = csv_of(study);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3);
  const Json json = Json::parse(json_of(study, {}));
  EXPECT_THAT(json.at("folds"), SizeIs(3));
  const Json whole = part_of(json.dump());
  for (const Json& maze : whole.at("mazes")) EXPECT_TRUE(maze.contains("fold"));
  EXPECT_EQ(XmlScanner(picture_of(study)).complaint(), "");
  EXPECT_THAT(picture_of(study), HasSubstr(fmt::format("({})", order.race.world->traits().unit)));
}

TEST_P(AWorld, HasSweeps) {
  if (GetParam()->name == "failures") LABMOUSE_SKIP_SANITIZED();  // the physical world does the same and more
  std::vector<NamedMaze> in = mazes();
  in.push_back({"contest-05", *maze_named("contest-05")});
  const Sweep sweep = hold_sweep(trial().swept, read_swept_values(trial().variation), in, order(), {}, patient());
  ASSERT_EQ(sweep.error, "");
  ASSERT_THAT(sweep.points, SizeIs(2));  // the third value is the first or second once more
  EXPECT_EQ(sweep.values, 2U);
  EXPECT_EQ(sweep.routeless, 1);
  EXPECT_GT(sweep.points[0].runs, sweep.points[0].failures);
  EXPECT_THAT(table_of(sweep, false), AllOf(HasSubstr("Score: " + order().world->traits().formula),
                                            HasSubstr(std::string(order().world->traits().why_no_bound))));
  EXPECT_EQ(XmlScanner(picture_of(sweep)).complaint(), "");
  EXPECT_THAT(picture_of(sweep), HasSubstr(std::string(order().world->traits().unit)));
}

TEST(Race, GivesMiceThatThrowDiceSeveralRuns) {
  RaceOrder order = test::in_steps();
  order.runs = 5;
  const Race race = hold_race(test::mice("random,flood"), {test::corridor()}, order);
  EXPECT_EQ(race.results.size(), 5U + 1U);
  EXPECT_EQ(standings_of(race).back().runs, 5);
}

TEST(Race, SeedsDependOnRaceMazeAndRun) {
  EXPECT_NE(contest_seed(1, "a", 0), contest_seed(2, "a", 0));
  EXPECT_NE(contest_seed(1, "a", 0), contest_seed(1, "b", 0));
  EXPECT_NE(contest_seed(1, "a", 0), contest_seed(1, "a", 1));
}

TEST(Race, SeedsDoNotDependOnTheFolder) {
  EXPECT_EQ(contest_seed(1, "here/a.txt", 3), contest_seed(1, "/there/a.txt", 3));
}

TEST(Race, TellsExternalMiceASeedThatNamesNoMaze) {
  Contestant mouse;
  mouse.name = "program:./mouse";
  mouse.external = true;
  mouse.runs = 2;
  const std::atomic<bool> stopped = true;  // before any contest is run
  RaceHooks hooks;
  hooks.stop = &stopped;
  RaceOrder order = test::in_steps();
  const auto results = hold_race({mouse}, {test::corridor(), test::loop()}, order, hooks).results;
  ASSERT_EQ(results.size(), 4U);
  EXPECT_EQ(results[0].told, results[2].told);
  EXPECT_EQ(results[1].told, results[3].told);
  EXPECT_NE(results[0].told, results[1].told);
  for (const ContestResult& result : results) EXPECT_EQ(result.seed, result.told);
  // A world that is stochastic throws others in each maze.
  order.world = default_world("physical");
  const auto physical = hold_race({mouse}, {test::corridor(), test::loop()}, order, hooks).results;
  EXPECT_EQ(physical[0].told, physical[2].told);
  EXPECT_NE(physical[0].seed, physical[2].seed);
  EXPECT_EQ(physical[0].seed, contest_seed(order.seed, "corridor", 0));
}

TEST(Race, ASeedGivesAnotherRace) {
  RaceOrder order = test::in_steps();
  order.seed = 2;
  EXPECT_NE(csv_of(test::race_of("random", order)), csv_of(test::race_of("random")));
}

TEST(RaceFolder, SavesUnderTheNamesOfMouseAndMaze) {
  const test::AFolder folder;
  NamedMaze maze = test::plank();
  maze.name = "far/away/plank.txt";
  const Race race = test::imagined_race({"./a b", "./a:b"}, {maze, test::plank()});
  const RaceFolder races(folder.path(), race);
  ContestResult second;
  second.mouse = second.maze = 1;
  EXPECT_EQ(races.save({}, {{}, "one", ""}), "");
  EXPECT_EQ(races.save(second, {{}, "two", "drawn"}), "");
  EXPECT_EQ(read_file(folder.path() + "/mms_._a_b/plank.jsonl").content, "one");
  EXPECT_EQ(read_file(folder.path() + "/mms_._a_b~2/plank~2.jsonl").content, "two");
  EXPECT_EQ(read_file(folder.path() + "/mms_._a_b~2/plank~2.svg").content, "drawn");
  EXPECT_NE(read_file(folder.path() + "/mms_._a_b/plank.svg").error, "");
  EXPECT_THAT(RaceFolder("/dev/null", race).save({}, {{}, "x", ""}), HasSubstr("error"));
}

}  // namespace
}  // namespace labmouse
