#include "labmouse/body/body.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/normal.hpp"
#include "labmouse/functions/position.hpp"

namespace labmouse {
namespace {

// A touch below these limits is a graze. They are those of kerikun11's mice, which go on after such touches, and end a
// run at others (docs/explanation/physical-model.md).
constexpr double graze_sine = 0.25881904510252076;   // of 15 degrees
constexpr double graze_speed = 50.0;                 // mm/s towards the wall
constexpr double graze_turn = 0.017453292519943295;  // a degree

}  // namespace

Body::Body(const Maze& maze, double cell, const Hardware& hardware, const ErrorScale& scale, std::uint64_t seed)
    : hardware_(hardware),
      robot_sample_(hardware, scale, maze.size(), seed),
      field_(maze, cell, robot_sample_.post_shifts()),
      plant_(field_, hardware, robot_sample_, seed),
      senses_(field_, hardware, robot_sample_, seed),
      placement_rng_(seed_for(seed, "placement")) {}

void Body::put(const Position& position, double angle) {
  const double level = robot_sample_.variation_of(ErrorCause::placement);
  const Variation& variation = hardware_.variation;
  const auto error = [&](double deviation) { return level * deviation * NormalNumber::of(placement_rng_.bits()); };
  const double x = error(variation.placement), y = error(variation.placement);
  plant_.put({position.x + x, position.y + y}, angle + error(variation.placement_turn));
  senses_.calibrate();
  senses_.read(plant_.motion(), plant_.voltage());
  crashed_ = grazing_ = false;
  since_slide_ = never;
}

void Body::put(Cell cell, Heading heading) {
  put({(cell.x + 0.5) * field_.cell(), (cell.y + 0.5) * field_.cell()}, pi / 2.0 * (1 - static_cast<int>(heading)));
}

Touch Body::step(const Drive& drive) {
  Touch touched = Touch::none;
  if (!crashed_) {
    plant_.step(drive);
    const auto contact = contact_of(field_, hardware_.chassis, plant_.motion().position, plant_.motion().ahead);
    since_slide_ = plant_.slides() ? 0 : std::min(since_slide_ + 1, never);
    if (contact) touched = touch(*contact);
    if (!contact) grazing_ = false;
  }
  senses_.read(plant_.motion(), plant_.voltage());
  return touched;
}

Touch Body::touch(const Contact& contact) {
  contact_ = contact;
  const BodyMotion& motion = plant_.motion();
  const Position out = way_of_eighths(eighths(contact.out));
  const Direction goes = turned_by(motion.ahead, motion.slip);
  const double forwards = motion.speed < 0.0 ? -1.0 : 1.0;
  // The sine of the angle between its motion and the wall; below 0 it moves into the wall.
  const double sine = forwards * (goes.cosine * out.x + goes.sine * out.y);
  if (sine < -graze_sine || -sine * std::abs(motion.speed) > graze_speed) {
    crashed_ = true;
    plant_.stop();
    return Touch::crash;
  }
  // Its nose is turned along the wall: to the left where the wall is to the right of it.
  const double across = motion.ahead.cosine * out.y - motion.ahead.sine * out.x;
  const double turn = sine < 0.0 ? std::min(graze_turn, -sine) * (across * forwards > 0.0 ? 1.0 : -1.0) : 0.0;
  plant_.graze({motion.position.x + contact.depth * out.x, motion.position.y + contact.depth * out.y}, turn,
               std::sqrt(std::max(0.0, 1.0 - sine * sine)));
  if (grazing_) return Touch::none;
  grazing_ = true;
  return Touch::graze;
}

}  // namespace labmouse
