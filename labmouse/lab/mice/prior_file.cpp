#include "labmouse/lab/mice/prior_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

constexpr std::string_view headline = "// labmouse prior 1";
constexpr std::size_t most_bytes = std::size_t{1} << 20U;
constexpr std::size_t all_numbers = wall_contexts + rim_contexts;

/// The number of a prior at a position in the file.
template <class Prior>
auto& number_at(Prior& prior, std::size_t position) {
  return position < prior.walls.size() ? prior.walls[position] : prior.rim[position - prior.walls.size()];
}

/// `30 of 12x12, 1 of 16x12`, from the smallest.
std::string sizes_of(std::vector<Size> mazes) {
  std::sort(mazes.begin(), mazes.end(), [](Size a, Size b) {
    return std::tuple(a.area(), a.width, a.height) < std::tuple(b.area(), b.width, b.height);
  });
  std::string text;
  for (auto from = mazes.begin(); from != mazes.end();) {
    const auto to = std::find_if(from, mazes.end(), [&](Size size) { return size != *from; });
    text += fmt::format("{}{} of {}x{}", text.empty() ? "" : ", ", to - from, from->width, from->height);
    from = to;
  }
  return text;
}

std::string comments_of(const PriorProvenance& provenance) {
  return fmt::format(
      "{}\n"
      "// Learned by labmouse {} from {} {}.\n"
      "// Sizes: {}.\n"
      "// {} walls counted, each once for each state of its surroundings in which it was unseen.\n"
      "// Log loss on these walls: {:.3f} nats each, {:.3f} with their common share for all (their entropy).\n"
      "// Each number is -32 ln P(open) of an unseen wall, rounded: 0 open, 22 as likely open as closed, 221 closed.\n"
      "// First {} by its eight neighbours: a number to the base three, the digit of neighbour 0 lowest; 0 unknown,\n"
      "// 1 open, 2 closed. Then {} of the rim of a goal room: 8 x its walls seen open (at most 2) + those closed.\n",
      headline, shown(provenance.version), provenance.mazes.size(), provenance.mazes.size() == 1 ? "maze" : "mazes",
      sizes_of(provenance.mazes), provenance.fit.walls, provenance.fit.log_loss, provenance.fit.entropy, wall_contexts,
      rim_contexts);
}

/// Reads lines into a prior, number by number.
class PriorReader {
 public:
  void read(const formats::Line& line) {
    if (line.text.starts_with("//")) return;
    auto words = formats::words_between_commas(line.text, all_numbers + 2);
    // A line that ends in a comma has an empty last word.
    const bool ended = words.back().text.empty() && words.size() > 1;
    if (ended) words.pop_back();
    for (const formats::Word& word : words) read(line, word);
    if (!ended && problems_.empty()) problems_.add(line.number, line.end(), "expected a comma after the number");
  }

  void finish(const formats::Line& last) {
    if (found_ < all_numbers && problems_.empty())
      problems_.add(last.number, last.end(), fmt::format("expected {} numbers, found {}", all_numbers, found_));
  }

  bool full() const { return problems_.full(); }

  ReadPriorResult result() const {
    if (!problems_.empty()) return {std::nullopt, problems_.all()};
    return {prior_, {}};
  }

 private:
  void read(const formats::Line& line, const formats::Word& word) {
    const auto number = formats::number_of(word.text, 0, 255);
    // A compiler would read a leading zero as octal.
    const bool plain = number && (word.text.size() == 1 || !word.text.starts_with('0'));
    if (!plain)
      problems_.add(line.number, word.column, "expected a number from 0 to 255, found " + formats::quoted(word.text));
    else if (found_ == all_numbers)
      problems_.add(line.number, word.column, fmt::format("expected {} numbers, found more", all_numbers));
    else if (found_ < all_numbers)
      number_at(prior_, found_) = static_cast<std::uint8_t>(*number);
    ++found_;
  }

  WallPrior prior_{};
  std::size_t found_ = 0;
  formats::ProblemList problems_;
};

}  // namespace

std::string write_prior(const WallPrior& prior, const PriorProvenance& provenance) {
  constexpr std::size_t in_a_line = 27;
  std::string text = comments_of(provenance);
  for (std::size_t i = 0; i < all_numbers; ++i) {
    const bool last = (i + 1) % in_a_line == 0 || i + 1 == all_numbers;
    text += fmt::format("{},{}", number_at(prior, i), last ? "\n" : "");
  }
  return text;
}

ReadPriorResult read_prior(std::string_view text) {
  const auto failure = [](int line, int column, std::string reason) {
    return ReadPriorResult{std::nullopt, {{line, column, std::move(reason)}}};
  };
  if (text.size() > most_bytes)
    return failure(0, 0, fmt::format("is too large: {} bytes, where at most {} are allowed", text.size(), most_bytes));
  const auto lines = formats::lines_of(text, text.size());
  if (lines.empty() || lines.front().text != headline)
    return failure(1, 1, fmt::format("is not a prior: its first line is not '{}'", headline));
  PriorReader reader;
  for (const formats::Line& line : lines)
    if (!reader.full()) reader.read(line);
  reader.finish(lines.back());
  return reader.result();
}

}  // namespace labmouse
