#include "labmouse/contest/clocked_body.hpp"

namespace labmouse {
namespace {

constexpr MazeTime tick_time = 1000;
/// If the mouse slid within so many ticks before a crash, sliding counts as the cause.
constexpr int slide_ticks = 300;

}  // namespace

ClockedBody::ClockedBody(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions,
                         std::uint64_t seed, MazeTime time_limit, PhysicalRecord& record)
    : maze_(maze),
      cell_(model.tables.cell),
      trace_every_(conditions.trace_every),
      log_(conditions.log),
      time_limit_(time_limit),
      record_(record),
      body_(maze, cell_, *model.robot.hardware, conditions.errors, seed) {
  record_.severity = body_.robot_sample().severity();
}

bool ClockedBody::step(const Drive& duties) {
  if (log_ != nullptr) log_->push_back({body_.sense(), duties, body_.motion()});
  const Touch touch = body_.step(duties);
  clock_ += tick_time;
  if (touch != Touch::none) record_.touches.push_back({clock_, pose(), touch == Touch::crash});
  return touch != Touch::crash && !out_of_time();
}

void ClockedBody::note_gates(DriveRun& run) {
  const Cell cell = this->cell();
  if (!maze_.size().contains(cell)) return;
  if (run.kind == DriveRun::Kind::laps) return note_laps(run, cell);
  if (!run.gate_out && cell != maze_.start()) run.gate_out = clock_;
  if (!run.gate_out || !maze_.is_goal(cell)) return;
  if (!run.gate_in) run.gate_in = clock_;
  const BodyMotion& motion = body_.motion();
  const double past = (motion.position.x - (cell.x + 0.5) * cell_) * motion.ahead.cosine +
                      (motion.position.y - (cell.y + 0.5) * cell_) * motion.ahead.sine;
  if (!run.centre && past >= 0.0) run.centre = clock_;
}

void ClockedBody::note_laps(DriveRun& run, Cell cell) {
  const bool leaves = in_start_ && cell == neighbour(maze_.start(), maze_.start_heading());
  in_start_ = cell == maze_.start();
  if (!leaves) return;
  if (run.gate_out)
    run.laps.push_back(clock_);
  else
    run.gate_out = clock_;
}

bool ClockedBody::trace_due() const { return trace_every_ > 0 && clock_ / tick_time % trace_every_ == 0; }

void ClockedBody::trace(const std::optional<BodyPose>& estimate) {
  if (!trace_due()) return;
  const auto levels = body_.sense().all_infrared();
  record_.trace.push_back({clock_, pose(), estimate, {levels.begin(), levels.end()}});
}

RunEnd ClockedBody::cause() const { return body_.slid_within(slide_ticks) ? RunEnd::slid : RunEnd::position_lost; }

}  // namespace labmouse
