// Every command with every robot, world, kind of mouse and word that its help names: each ends by itself, and says what
// is wrong in the program's own words. What there is to run is read from the program, so a new one is run, too.
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using Words = std::vector<std::string>;

/// An option or a positional argument of a command, as its help has it.
struct Taken {
  std::string name;  ///< with its dashes
  std::string type;  ///< "ROBOT", "TEXT"
  Words choices;     ///< of a text that is one of some words
  bool is_mouse() const { return type == "MOUSE" || type == "SPEC"; }
  bool is_world() const { return name == "--world" && !choices.empty(); }
};

Words split(const std::string& text, char separator) {
  Words parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// What makes a command do something cheap, without what the test chooses.
const std::map<std::string, Words> usual = {
    {"race", {"--mazes", "m.txt", "--runs", "1", "--jobs", "1"}},
    {"compare", {"flood:stride=2", "--mazes", "m.txt", "--most", "2", "--jobs", "1"}},
    {"sweep", {"--vary", "stride=3", "--mazes", "m.txt", "--runs", "1", "--jobs", "1"}},
    {"study", {"--mazes", "m.txt", "n.txt", "--folds", "2", "--runs", "1", "--jobs", "1"}},
    {"tune", {"--params", "stride", "--evaluations", "2", "--mazes", "m.txt", "--runs", "1", "--jobs", "1"}},
    {"mice-file check", {"mice.toml"}},
    {"mice-file init", {"robots", "--overwrite"}},
    {"league init", {"season", "--practice", "m.txt", "--examination", "1"}},
    {"league add", {"season", "robots", "--no-check"}},
    {"league run", {"season"}},
    {"league publish", {"season", "-o", "site"}},
    {"grade", {"--mice", "mice.toml", "--tasks", "tasks.toml", "--jobs", "1"}},
    {"run", {"m.txt"}},
    {"mms", {"false", "--maze", "m.txt"}},
    {"learn", {"m.txt", "-o", "learned.prior"}},
    {"show", {"m.txt"}},
    {"inspect", {"m.txt"}},
    {"make", {"empty", "--size", "4x4"}},
    {"convert", {"m.txt", "-"}},
    {"mice", {}},
    {"robot show", {"--svg", "robot.svg"}},
    {"robot fit", {"--turns", "turns.txt"}},
    {"robot compare", {"log.csv"}},
    {"robot list", {}},
    {"rules show", {}},
    {"rules list", {}},
    {"bound", {"m.txt"}},
    {"route", {"m.txt", "--svg", "route.svg"}},
    {"drive", {"--mazes", "m.txt", "--runs", "1", "--jobs", "1"}},
    {"failure-rates", {"--mazes", "m.txt", "--variation", "1", "--jobs", "1"}},
    {"replay", {"r.jsonl"}},
    {"score", {"r.jsonl"}},
    {"live", {"robot.log"}},
    {"page", {"-o", "page.html"}},
    {"report", {"results.json", "-o", "report.html"}},
    {"store list", {"s.db"}},
    {"store show", {"s.db"}},
    {"store race", {"s.db"}},
    {"store export", {"s.db"}},
    {"store merge", {"s.db", "-o", "all.db"}},
    {"store verify", {"s.db"}},
    {"store forget", {"s.db", "--seed", "7"}},
    {"bench", {"--memory", "--robot", "classic"}},
    {"demo", {"--no-browser"}},
    {"doctor", {}},
};

class EveryCommand : public test::AUser {
 protected:
  EveryCommand() {
    // A mouse in seconds leaves its start to the north.
    file("m.txt", "o---o\n| G |\no   o\n|   |\no   o\n| S |\no---o\n");
    file("n.txt", "o---o\n| G |\no   o\n| S |\no---o\n");
    file("robot.py", "class Robot:\n  def __init__(self, size):\n    pass\n");
    std::filesystem::create_directories(folder_ / "robots");
    file("robots/robot.py", content("robot.py"));
    std::string mice_file;
    for (const std::string& mouse : built_in_mice())
      mice_file += "[[mouse]]\nname = \"the " + mouse + "\"\nmouse = \"" + mouse + "\"\n";
    file("mice.toml", mice_file);
    file("robot.log", "0 0 N 101\n0 1 N 101\n");
    file("tasks.toml", "[[task]]\nname = 'arrives'\npoints = 1\nmazes = ['m.txt']\nfinish = true\n");
  }

  /// What of a race later commands take.
  void hold_a_race() const {
    labmouse({"run", "flood", "m.txt", "--record", "r.jsonl"});
    const test::Ended race =
        labmouse({"race", "--mice", "flood", "--mazes", "m.txt", "--store", "s.db", "--format", "json"});
    file("results.json", race.out);
  }

  /// The commands that do something, with the words that lead to them: "robot show".
  Words commands(const std::string& above = "") const {
    Words found;
    for (const std::string& name : first_words("Subcommands:", help_of(above))) {
      const std::string whole = above.empty() ? name : above + " " + name;
      const Words below = commands(whole);
      found.insert(found.end(), below.begin(), below.end());
      if (below.empty()) found.push_back(whole);
    }
    return found;
  }

  std::vector<Taken> taken_by(const std::string& command) const {
    std::vector<Taken> all;
    bool positional = false;
    for (const std::string& line : split(help_of(command), '\n')) {
      if (line.ends_with(':')) positional = line == "Positionals:";
      std::istringstream words(line);
      std::string name, type;
      words >> name >> type;
      if (!line.starts_with("  ") || line.starts_with("   ") || (!positional && !name.starts_with("-"))) continue;
      Taken taken = {positional ? "" : name, type.substr(0, type.find_first_of(":=")), {}};
      const auto open = type.find('{'), close = type.find('}');
      if (open != std::string::npos) taken.choices = split(type.substr(open + 1, close - open - 1), ',');
      all.push_back(taken);
    }
    return all;
  }

  /// One mouse of each kind that is built in, by what the program says of them.
  Words built_in_mice() const {
    std::map<std::string, std::string> kinds;
    for (nlohmann::json mouse : nlohmann::json::parse(labmouse({"mice", "--format", "json"}).out)) {
      const std::string name = mouse["name"];
      for (const char* key : {"name", "summary", "parameters", "method", "source"}) mouse.erase(key);
      kinds.emplace(mouse.dump(), name);
    }
    Words mice = {"oracle"};
    for (const auto& [kind, name] : kinds) mice.push_back(name);
    return mice;
  }
  Words mice() const {
    Words mice = built_in_mice();
    mice.insert(mice.end(), {"mine=flood:stride=1", "capstone:robot.py", "program:false", "controller:false",
                             "flood-return:parts=false", "mms:false", "mice-file:mice.toml", "nobody"});
    return mice;
  }

  /// All values to be tried for what a command takes; none where any is like another.
  Words values_of(const Taken& taken) const {
    if (taken.is_mouse()) return mice();
    if (taken.type == "ROBOT") return first_words("", labmouse({"robot", "list"}).out);
    if (taken.type == "RULES") return first_words("", labmouse({"rules", "list"}).out);
    return taken.choices;
  }

  void try_out(const std::string& command, const Words& chosen) const {
    Words words = split(command, ' ');
    words.insert(words.end(), chosen.begin(), chosen.end());
    const auto more = usual.find(command);
    ASSERT_NE(more, usual.end()) << "a new command: give it its usual words";
    words.insert(words.end(), more->second.begin(), more->second.end());
    const test::Ended ended = labmouse(words);
    SCOPED_TRACE(testing::PrintToString(words));
    EXPECT_TRUE(ended.code >= 0 && ended.code <= 2) << ended.code << ended.err;
    for (const char* foreign : {"bad_", "std::", "[json", "terminate", "exception", "basic_string", "labmouse failed"})
      EXPECT_EQ((ended.out + ended.err).find(foreign), std::string::npos) << foreign << ended.err;
    if (ended.code != 2) return;
    EXPECT_EQ(ended.out, "");
    bool says_what = false;
    for (const std::string& line : split(ended.err, '\n')) {
      says_what = says_what || line.starts_with("error: ") || line.find(": error: ") != std::string::npos;
    }
    EXPECT_TRUE(says_what) << ended.err;
  }

  /// The option or positional argument with that value.
  static Words words_of(const Taken& taken, const std::string& value) {
    return taken.name.empty() ? Words{value} : Words{taken.name, value};
  }

  static Words both(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static Words split_at(std::string text, std::string_view mark) {
    Words parts;
    for (auto end = text.find(mark); end != std::string::npos; end = text.find(mark)) {
      parts.push_back(text.substr(0, end));
      text.erase(0, end + mark.size());
    }
    parts.push_back(text);
    return parts;
  }

  /// The words in front of the lines below a heading, up to a line without any.
  static Words first_words(std::string_view heading, const std::string& text) {
    Words words;
    bool below = heading.empty();
    for (const std::string& line : split(text, '\n')) {
      std::string word;
      std::istringstream(line) >> word;
      if (below && word.empty()) break;
      if (below) words.push_back(word);
      below = below || line == heading;
    }
    return words;
  }

  std::string help_of(const std::string& command) const {
    std::string& help = helps_[command];
    if (!help.empty()) return help;
    Words words = split(command, ' ');
    words.emplace_back("--help");
    return help = labmouse(words).out;
  }

 private:
  mutable std::map<std::string, std::string> helps_;
};

TEST_F(EveryCommand, EndsWellWithEachWordOfItsHelp) {
  hold_a_race();
  const Words all = commands();
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), usual.size());
  std::set<std::string> tried;
  for (const std::string& command : all) {
    const std::vector<Taken> taken = taken_by(command);
    Words some;  // mouse, where one is asked for
    for (const Taken& each : taken)
      if (each.is_mouse() && each.name != "--hindsight") some = words_of(each, "flood");
    try_out(command, some);
    for (const Taken& each : taken) {
      // Robots and worlds in each command; of all else, which commands share, once is enough.
      const bool again = each.is_world() || each.type == "ROBOT";
      if (each.is_mouse() || (!tried.insert(each.name + testing::PrintToString(each.choices)).second && !again))
        continue;
      for (const std::string& value : values_of(each)) try_out(command, both(words_of(each, value), some));
    }
  }
}

TEST_F(EveryCommand, HasAnExampleOfItselfAtTheEndOfItsHelp) {
  Words all = commands();
  all.insert(all.end(), {"robot", "rules", "store", "mice-file", "league"});
  for (const std::string& command : all) {
    const std::string help = help_of(command);
    const auto begin = help.rfind("\nExample: labmouse ");
    ASSERT_NE(begin, std::string::npos) << command;
    bool own = false;
    // What is asked of each program in the pipes of the example.
    for (const std::string& line : split(help.substr(begin + 1), '\n'))
      for (std::string part : split_at(line, " && ")) {
        part = part.substr(std::min(part.find("labmouse "), part.size()));
        if (part != "labmouse " + command && !part.starts_with("labmouse " + command + " ")) continue;
        own = true;
        if (help.find("python3 -m ") != std::string::npos) continue;  // lists the options in its own help
        for (const std::string& word : split(part, ' '))
          if (word.starts_with("--")) {
            EXPECT_NE(help.find(" " + word), std::string::npos) << word << " of " << part;
          }
      }
    EXPECT_TRUE(own) << help.substr(begin);
  }
}

TEST_F(EveryCommand, NamesTheDefaultsOfAllWorldsInItsHelp) {
  const std::string help = help_of("race");
  EXPECT_THAT(help, test::Says("--robot", "classic in seconds", "kerise in physical", "failures"));
  EXPECT_THAT(help, test::Says("--runs", "default: 20 in", "failures", "3 in physical"));
  for (const char* command : {"study", "sweep", "tune"})
    EXPECT_THAT(help_of(command), test::Says("`labmouse race --help`: ", "--robot", "--runs", "--store"));
}

TEST_F(EveryCommand, EndsWellWithEachKindOfMouse) {
  bool in_worlds = false;
  for (const std::string& command : commands()) {
    const std::vector<Taken> taken = taken_by(command);
    Words worlds;
    for (const Taken& each : taken)
      if (each.is_world()) worlds = each.choices;
    for (const Taken& each : taken) {
      if (!each.is_mouse()) continue;
      for (const std::string& mouse : mice()) try_out(command, words_of(each, mouse));
      // Who enters which world is one mechanism, which the first of these commands shows: `race`.
      if (std::exchange(in_worlds, in_worlds || !worlds.empty())) continue;
      for (const std::string& mouse :
           both(built_in_mice(), {"program:false", "controller:false", "mms:false", "flood-return:parts=false"}))
        for (const std::string& world : worlds) try_out(command, both(words_of(each, mouse), {"--world", world}));
    }
  }
}

}  // namespace
}  // namespace labmouse
