// labmouse learn: what to expect of unseen walls, from a folder of mazes.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "labmouse/lab/prior_learning.hpp"

namespace labmouse::cli {
namespace {
struct LearnOptions {
  std::vector<std::string> mazes;
  Places places;
  std::string out;
};
}  // namespace

void add_learn(CLI::App& app, int& exit) {
  auto options = std::make_shared<LearnOptions>();
  CLI::App* command = app.add_subcommand("learn", "Learn what to expect of unseen walls");
  command->add_option("mazes", options->mazes, "Maze files or folders")->required()->type_name("PATH");
  command->add_option("-o,--out", options->out, "Where to save")->required()->type_name("FILE");
  command->callback([options, &exit] {
    const MazeCollection found = find_mazes(options->mazes, options->places);
    std::vector<Maze> mazes;
    for (const auto& m : found.mazes) mazes.push_back(m.maze);
    const WallPrior prior = learn_prior(mazes, Rules());
    std::string text = fmt::format("// labmouse prior 1\n// counted in {} mazes\n", mazes.size());
    int column = 0;
    const auto add = [&](std::uint8_t number) { text += fmt::format("{},{}", number, ++column % 27 == 0 ? "\n" : ""); };
    for (const auto n : prior.walls) add(n);
    for (const auto n : prior.rim) add(n);
    save(options->out, text + "\n");
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
