#include "labmouse/lab/drawing/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/drawing/axis.hpp"
#include "tests/lab/drawing/drawing_samples.hpp"
#include "tests/lab/xml_scanner.hpp"

namespace labmouse {
namespace {

using drawing::Axis;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> labels(const Axis& axis) {
  std::vector<std::string> list;
  for (const Axis::Tick& tick : axis.ticks()) list.push_back(tick.label);
  return list;
}

TEST(Axis, HasRoundTicks) {
  EXPECT_THAT(labels({0, 1, 0, 100, 5}), ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels({0.5, 8.5, 0, 100, 10}), ElementsAre("1", "2", "3", "4", "5", "6", "7", "8"));
  EXPECT_THAT(labels({-0.04, 1.04, 0, 100, 10}), ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels({17, 261, 0, 100, 8}), ElementsAre("50", "100", "150", "200", "250"));
  EXPECT_THAT(labels({-20, 20, 0, 100, 4}), ElementsAre("-20", "-10", "0", "10", "20"));
  EXPECT_THAT(labels({20.009, 20.041, 0, 100, 4}), ElementsAre("20.01", "20.02", "20.03", "20.04"));
}

TEST(Axis, HasNoTicksBetweenWholeNumbersWhereThereIsNothing) {
  EXPECT_THAT(labels({0.9, 3.1, 0, 100, 10, 1.0}), ElementsAre("1", "2", "3"));
  EXPECT_THAT(draw_plot({"", "", "", "", {{"1", 5, {}, false, ""}, {"2", 6, {}, false, ""}}, "", "", ""}),
              Not(HasSubstr(">1.5<")));
}

TEST(Axis, PlacesValuesBetweenItsEnds) {
  const Axis down(10, 20, 300, 100, 4);
  EXPECT_DOUBLE_EQ(down.place(10), 300);
  EXPECT_DOUBLE_EQ(down.place(15), 200);
  EXPECT_DOUBLE_EQ(down.ticks().front().at, 300);
}

TEST(Axis, PutsNamesSideBySide) {
  const Axis names({"a", "b"}, 0, 100);
  EXPECT_DOUBLE_EQ(names.ticks()[0].at, 25);
  EXPECT_DOUBLE_EQ(names.ticks()[1].at, 75);
  EXPECT_EQ(names.ticks()[1].label, "b");
}

Plot plot_of(std::vector<PlotPoint> points) {
  Plot plot;
  plot.points = std::move(points);
  return plot;
}

/// The line from mean to mean.
constexpr std::string_view means = "stroke-opacity=\"0.8\" d=\"";

TEST(Plot, ConnectsNumbersInTheirOrder) {
  const std::string svg =
      draw_plot(plot_of({{"10", 5, {}, false, ""}, {"9", 5, {}, false, ""}, {"11", 5, {}, false, ""}}));
  ASSERT_THAT(svg, HasSubstr(means));
  const std::string line = svg.substr(svg.find(means) + means.size());
  double first = 0, second = 0, third = 0, y = 0;
  ASSERT_EQ(std::sscanf(line.c_str(), "M%lf %lfL%lf %lfL%lf %lf", &first, &y, &second, &y, &third, &y), 6);
  EXPECT_LT(first, second);
  EXPECT_LT(second, third);
}

TEST(Plot, ConnectsNoNames) {
  const std::string svg = draw_plot(plot_of({{"yes", 5, {}, false, ""}, {"no", 6, {}, false, ""}}));
  EXPECT_THAT(svg, Not(HasSubstr(means)));
  EXPECT_THAT(svg, HasSubstr(">yes<"));
}

TEST(Plot, OfManyLongNamesIsWideEnoughForThem) {
  std::vector<PlotPoint> points;
  for (int i = 0; i < 24; ++i) points.push_back({"left-right-ahead-" + std::to_string(i), 5, {}, false, ""});
  const std::string svg = draw_plot(plot_of(points));
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  int width = 0;
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("viewBox"), "viewBox=\"0 0 %d", &width), 1);
  EXPECT_GT(width, 24 * 19 * 7);
}

TEST(Plot, CutsWhatIsTooLong) {
  Plot plot = plot_of({{"1", 5, Interval{4, 6}, true, "one"}});
  plot.title = plot.x_label = plot.y_label = std::string(500, 'w');
  const std::string svg = draw_plot(plot);
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  EXPECT_EQ(count(svg, "w…</text>"), 3);
}

}  // namespace
}  // namespace labmouse
