#include "labmouse/lab/drawing/sheet.hpp"

#include <fmt/format.h>

#include "labmouse/lab/text/printable.hpp"

namespace labmouse::drawing {

std::string Sheet::with(std::string_view svg) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"labmouse\" role=\"img\" viewBox=\"0 0 {0} {1}\" "
      "width=\"{0}\" height=\"{1}\">\n<title>{2}</title>\n<desc>{3}</desc>\n<style>{4}</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" {5}/>\n"
      "<g font-family=\"system-ui, -apple-system, 'Segoe UI', 'Liberation Sans', sans-serif\" font-size=\"13\">\n"
      "{6}</g>\n</svg>\n",
      width, height, xml_escaped(title), xml_escaped(description), dark_style_sheet(tones), fill(paper), svg);
}

std::string fitted(std::string_view words, int letters) {
  std::u32string text = printable(words);
  const auto room = static_cast<std::size_t>(letters);
  if (text.size() > room) text = text.substr(0, room - 1) + U'…';
  return utf8(text);
}

namespace {

/// Cuts a title that is too long before its last colon: the outcome after it matters most.
std::string fitted_title(std::string_view words, int letters) {
  constexpr std::u32string_view before_outcome = U": ";
  const std::u32string text = printable(words);
  const auto room = static_cast<std::size_t>(letters);
  const auto colon = text.rfind(before_outcome);
  if (text.size() <= room || colon == std::u32string::npos) return fitted(words, letters);
  const std::u32string outcome = text.substr(colon);
  if (outcome.size() >= room) return fitted(utf8(outcome.substr(before_outcome.size())), letters);
  return utf8(text.substr(0, room - outcome.size() - 1) + U'…' + outcome);
}

}  // namespace

std::string heading_svg(Point begin, int right, std::string_view words) {
  constexpr int letter_width = 10;
  const std::string title = fitted_title(words, (right - begin.x) / letter_width);
  if (title.empty()) return "";
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"16\" font-weight=\"600\" {}>{}</text>\n", begin.x, begin.y,
                     fill(ink), xml_escaped(title));
}

}  // namespace labmouse::drawing
