// The built-in parts of a controller as a program: part_program [until N] PART... offers the parts and answers as they
// do, without known walls. After N questions it ends with exit code 3.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "labmouse/controller/gains.hpp"
#include "labmouse/controller/reference_parts.hpp"
#include "labmouse/controller/wall_reader.hpp"
#include "labmouse/lab/robots/robot_files.hpp"

namespace {

using namespace labmouse;

struct Line {
  explicit Line(const std::string& text) : in(text) { in >> word; }

  double number() {
    std::string text;
    in >> text;
    return std::strtod(text.c_str(), nullptr);
  }
  int whole() { return static_cast<int>(number()); }
  Direction direction() {
    const double cosine = number();
    return {number(), cosine};
  }
  Position position() {
    const double x = number();
    return {x, number()};
  }
  Sense sense() {
    Sense sense;
    sense.tick = static_cast<std::uint32_t>(whole());
    for (std::int32_t& count : sense.counts) count = whole();
    sense.gyro = static_cast<std::int16_t>(whole());
    for (std::int16_t& acceleration : sense.acceleration) acceleration = static_cast<std::int16_t>(whole());
    // Of four infrared sensors and a ToF sensor.
    for (std::size_t i = 0; i < 4; ++i) sense.infrared[i] = static_cast<std::int16_t>(whole());
    sense.ranges[0].distance = static_cast<std::uint16_t>(whole());
    sense.ranges[0].is_new = whole() != 0;
    sense.millivolts = static_cast<std::uint16_t>(whole());
    return sense;
  }
  Target target() {
    Target target;
    target.position = position();
    target.ahead = direction();
    for (double* part : {&target.speed, &target.speeding, &target.turning, &target.twisting}) *part = number();
    return target;
  }
  PoseEstimate estimate() {
    PoseEstimate estimate;
    estimate.position = position();
    estimate.ahead = direction();
    auto& p = estimate.covariance;
    for (double* part : {&estimate.slip, &estimate.speed, &estimate.turning, &p[0][0], &p[0][1], &p[0][2], &p[1][1],
                         &p[1][2], &p[2][2]})
      *part = number();
    return estimate;
  }

  std::istringstream in;
  std::string word;
};

void say(const std::string& line) { std::cout << line << std::endl; }

void say(const PoseEstimate& is) {
  const auto& p = is.covariance;
  say(fmt::format("estimate {} {} {} {} {} {} {} {} {} {} {} {} {}", is.position.x, is.position.y, is.ahead.cosine,
                  is.ahead.sine, is.slip, is.speed, is.turning, p[0][0], p[0][1], p[0][2], p[1][1], p[1][2], p[2][2]));
}

int whole_duty(float duty) { return static_cast<int>(std::lround(duty * 32767.0F)); }

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  int left = -1;
  if (words.size() > 1 && words.front() == "until") {
    left = std::atoi(words[1].c_str());
    words.erase(words.begin(), words.begin() + 2);
  }
  const DriveModel model = find_robot("kerise").model;
  const Hardware& hardware = *model.robot.hardware;
  const double cell = model.tables.cell;
  const Gains gains = gains_for(hardware, cell);
  Size size{0, 0};
  std::optional<CorrectedEstimator> estimator;
  WallReader reader(hardware, cell);
  MotorTracker tracker(gains, hardware.motors);
  for (std::string text; std::getline(std::cin, text);) {
    Line line(text);
    const bool asks = line.word == "estimate" || line.word == "read" || line.word == "follow";
    if (asks && left-- == 0) return 3;
    if (line.word == "size") {
      size.width = line.whole();
      size.height = line.whole();
    } else if (line.word == "begin") {
      estimator.emplace(hardware, cell, size, CorrectionChoice(), gains.speed_filter);
      say(fmt::format("labmouse pilot 1 {}", fmt::join(words, " ")));
    } else if (line.word == "put") {
      const Position position = line.position();
      estimator->put(position, line.direction());
    } else if (line.word == "estimate") {
      const Sense sense = line.sense();
      say(estimator->estimate(sense, line.target(), nullptr));
    } else if (line.word == "look") {
      Pose pose;
      pose.cell.x = line.whole();
      pose.cell.y = line.whole();
      std::string name;
      line.in >> name;
      for (const Heading heading : all_headings)
        if (name_of(heading) == name) pose.heading = heading;
      reader.begin(pose);
    } else if (line.word == "read") {
      const Sense sense = line.sense();
      const PoseEstimate estimate = line.estimate();
      reader.read(sense, estimate);
      const WallEvidence evidence = reader.evidence(estimate);
      say(fmt::format("evidence {} {} {}", evidence.left, evidence.ahead, evidence.right));
    } else if (line.word == "rest") {
      tracker.reset();
    } else if (line.word == "follow") {
      const Sense sense = line.sense();
      const Target target = line.target();
      const Drive duties = tracker.follow(sense, target, line.estimate());
      say(fmt::format("drive {} {}", whole_duty(duties.left), whole_duty(duties.right)));
    }
  }
}
