// Contests of programs that run in the page, through the line protocol.
#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <memory>

#include "labmouse/external/dialogue.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/page/external.hpp"
#include "labmouse/lab/page/page_world.hpp"
#include "labmouse/lab/records/packed_record.hpp"
#include "labmouse/lab/replays/play.hpp"
#include "labmouse/lab/steps/steps_files.hpp"
#include "labmouse/lab/steps/steps_world.hpp"

namespace labmouse {
namespace {

using Clock = std::chrono::steady_clock;

/// A running contest.
struct ExternalContest {
  ExternalContest(int contest_id, Contestant external, NamedMaze its_maze, const Rules& its_rules,
                  std::uint64_t its_seed)
      : id(contest_id),
        mouse(std::move(external)),
        maze(std::move(its_maze)),
        rules(its_rules),
        seed(its_seed),
        dialogue(maze.maze, rules, seed) {}

  int id;
  Contestant mouse;
  NamedMaze maze;
  Rules rules;
  std::uint64_t seed;
  Dialogue dialogue;
  Clock::time_point asked{};
  Clock::duration spent{};
};

/// The limit of running contests, so that those that are never ended do not fill the memory; a new one replaces the
/// oldest.
constexpr std::size_t most_held_contests = 8;
std::vector<std::unique_ptr<ExternalContest>> contests;
int last_id = 0;

ExternalContest* find_contest(PageRequest& request) {
  const int id = request.whole("contest", 1, std::numeric_limits<int>::max());
  for (const auto& contest : contests)
    if (contest->id == id) return contest.get();
  request.reject("there is no such contest, or the core was started anew; start it again");
  return nullptr;
}

/// The next lines for the program, and the progress of the contest.
Json next_lines(ExternalContest& contest) {
  Json lines = Json::array();
  const std::string text = contest.dialogue.take_lines();
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  contest.asked = Clock::now();
  return {{"contest", contest.id},
          {"lines", std::move(lines)},
          {"ended", contest.dialogue.contest().ended()},
          {"steps", contest.dialogue.contest().record().steps.size()}};
}

/// Reads how a program ended, as the page reports it.
ProgramEnd read_end(PageRequest& request, const ReadJson& json) {
  PageRequest fields(json);
  const std::string kind = fields.text("kind");
  ProgramEnd end;
  if (kind == "failed") {
    const int line = fields.has("line") ? fields.whole("line", 1, std::numeric_limits<int>::max()) : 0;
    end.what = fmt::format("an error{}: {}", line > 0 ? fmt::format(" in line {}", line) : "", fields.text("message"));
  } else if (kind == "exited") {
    end.what = fmt::format("exit code {}", fields.whole("code", 0, 255));
  } else if (kind == "silent") {
    end = {ProgramEnd::Kind::silent, fmt::format("{:.3g} s", fields.not_negative("seconds"))};
  } else if (kind == "printed") {
    end = {ProgramEnd::Kind::printed, "more than it may for one answer: " + fields.text("what")};
  } else {
    fields.reject("'kind' is no way to end");
  }
  request.reject(fields.error());
  return end;
}

}  // namespace

PageReply answer_external_begin(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  Contestant mouse = read_page_external(request);
  NamedMaze maze = request.maze();
  std::uint64_t seed = request.seed();
  const Rules rules = request.rules();
  const bool races = request.has("races") && request.flag("races");
  if (!request.error().empty()) return failed(request.error());
  if (races) seed = seed_of_program(seed, 0);
  if (contests.size() == most_held_contests) contests.erase(contests.begin());
  contests.push_back(std::make_unique<ExternalContest>(++last_id, std::move(mouse), std::move(maze), rules, seed));
  return answered(next_lines(*contests.back()));
}

PageReply answer_external_hear(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  ExternalContest* contest = find_contest(request);
  const std::string printed = request.has("printed") ? request.text("printed") : "";
  const std::string output = request.has("output") ? request.text("output") : "";
  const ProgramEnd end = request.has("end") ? read_end(request, json["end"]) : ProgramEnd();
  if (!request.error().empty()) return failed(request.error());
  contest->spent += Clock::now() - contest->asked;
  contest->dialogue.hear_errors(printed);
  contest->dialogue.hear(output);
  if (request.has("end")) contest->dialogue.give_up(end);
  return answered(next_lines(*contest));
}

PageReply answer_external_end(const ReadJson& json, std::string_view) {
  PageRequest request(json);
  ExternalContest* contest = find_contest(request);
  if (!request.error().empty()) return failed(request.error());
  Dialogue& dialogue = contest->dialogue;
  dialogue.give_up({ProgramEnd::Kind::interrupted, ""});
  const RecordFile file =
      record_file_of(contest->mouse, contest->maze, contest->rules, contest->seed, dialogue.take_record());
  Json play = play_json(file);
  play["again"] = again_json(*steps_world(contest->rules));
  PageReply reply = answered({{"play", std::move(play)},
                              {"record", write_record(file)},
                              {"packed", pack_record(file)},
                              {"started", dialogue.greeted()},
                              {"microseconds", std::chrono::duration<double, std::micro>(contest->spent).count()}});
  std::erase_if(contests, [&](const auto& each) { return each.get() == contest; });
  return reply;
}

}  // namespace labmouse
