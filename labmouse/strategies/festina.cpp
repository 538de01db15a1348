// festina: wraps another strategy, and adds a log-odds map and a choice of pace. It searches more slowly after crashes,
// makes speed runs faster after each success, and makes a slow, safe run if no speed run finished.
//
// Limits: it adapts only to how runs ended; it does not know the noise level.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/mouse/forwarding_strategy.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

/// A parameter without effect in worlds without errors: there, all paces are equal, and no reading contradicts the map.
constexpr Parameter number_with_errors(std::string_view name, std::string_view value, double low, double high,
                                       std::string_view meaning) {
  return Parameter::real(name, value, low, high, meaning, ParameterScope::errors);
}

constexpr std::array festina_parameters = {
    Parameter::choice(
        "strategy", "by-rules", "by-rules/ariadne/certify/flood-return",
        "Strategy that explores; by-rules takes ariadne where the time in the maze counts, and certify elsewhere.",
        ParameterScope::seconds),
    number_with_errors("search", "1", 0.2, 1.0, "Speed of the first search run, as a share of the usual speed."),
    number_with_errors("slower", "0.9", 0.3, 1.0,
                       "Factor on the speed of search runs after each crash in a search run (no unit)."),
    number_with_errors("run", "0", 0.0, 1.0,
                       "Speed of the first speed run, as a share of the usual speed; 0 chooses it by the rules."),
    number_with_errors("step", "0.85", 0.3, 0.95,
                       "Factor on the speed of speed runs after each crash in a speed run (no unit)."),
    Parameter::flag("safe", "yes", "Whether it makes a safe run at search speed if no speed run finished.",
                    ParameterScope::errors),
    Parameter::choice(
        "map", "log-odds", "log-odds/log-odds-prior",
        "How contradicting wall readings are handled: a log-odds map weighs them (log-odds), with a prior "
        "learned from other mazes (log-odds-prior).",
        ParameterScope::errors),
};

/// Lowest pace with which a search can reach the goal within half of the time limit. It passes about half of the cells,
/// and turns add a quarter.
double least_pace_of(const Briefing& briefing) {
  constexpr double least = 0.3, turns = 1.25;
  const double cells = turns * briefing.size.area() * briefing.drive.model->search.cell;
  return std::clamp(cells / (briefing.drive.pace * static_cast<double>(briefing.drive.time_limit)), least, 1.0);
}

/// Pace of the first speed run: slower if a crash is costly, because runs are few or an untouched mouse gets a bonus.
double first_run_pace(const Briefing& briefing, double chosen) {
  constexpr double with_bonus = 0.75, of_few = 0.9, least = 0.2;
  constexpr int many_runs = 10;
  if (chosen > 0.0) return std::max(chosen, least);
  if (briefing.drive.untouched_bonus > 0) return with_bonus;
  return briefing.drive.most_runs < many_runs ? of_few : 1.0;
}

const BuiltinMouse& explorer_for(const Briefing& briefing, std::string_view chosen) {
  if (chosen != "by-rules") return *find_mouse(chosen);
  return briefing.drive.maze_time_divisor > 0 ? ariadne_mouse : certify_mouse;
}

/// Chooses the pace of the next speed run from the fastest one that finished and the slowest one that crashed.
class RunLadder {
 public:
  RunLadder(double first, double step) : next_(first), step_(step) {}

  double pace() const { return next_; }
  /// Number of crashed runs, as long as none has finished.
  int crashes_alone() const { return good_ ? 0 : crashes_; }
  void crashed() {
    ++crashes_;
    bad_ = std::min(bad_.value_or(1.0), next_);
    next_ = good_ ? middle() : std::max(least, next_ * step_);
  }
  /// Records a finished run. Returns whether a faster one is worth trying.
  bool went_well() {
    good_ = std::max(good_.value_or(0.0), next_);
    if (*good_ >= 1.0) return false;
    next_ = bad_ ? middle() : std::min(1.0, next_ / step_);
    return next_ > near * *good_;
  }

 private:
  static constexpr double least = 0.25, near = 1.05;
  double middle() const { return std::sqrt(*good_ * *bad_); }

  double next_, step_;
  int crashes_ = 0;
  std::optional<double> good_, bad_;
};

class Festina final : public ForwardingDriver {
 public:
  /// `briefing` is that of the wrapped strategy; `fields` are null if the caller's briefing already had some.
  Festina(const Briefing& briefing, std::unique_ptr<DriveFields> fields, std::unique_ptr<DrivingStrategy> strategy,
          const Settings& settings, double search_pace, double least_pace, double run_pace, double usual_pace)
      : ForwardingDriver(*strategy),
        goals_(briefing.goals),
        most_runs_(briefing.drive.most_runs),
        own_fields_(std::move(fields)),
        fields_(briefing.drive.fields),
        strategy_(std::move(strategy)),
        usual_pace_(usual_pace),
        search_pace_(search_pace),
        least_pace_(least_pace),
        slower_(settings.real("slower")),
        ladder_(run_pace, settings.real("step")),
        makes_sure_(settings.flag("safe")),
        map_(*map_kind_of(settings.choice("map"))) {}

  Action decide(const Sighting& seen) override { return then(mouse().decide(seen)); }
  void carried(std::int64_t time) override {
    stands_at_start_ = true;
    safe_run_ = false;
    if (running_)
      ladder_.crashed();
    else
      search_pace_ = std::max(least_pace_, search_pace_ * slower_);
    mouse().searches_at(usual_pace_ * search_pace_);
    mouse().carried(time);
  }
  Action consider(const LogOddsMap& log_odds, const SearchPlace& place, std::int64_t time) override {
    if (safe_run_) return safe_step(log_odds, place);
    const Action action = then(mouse().consider(log_odds, place, time));
    if (!std::exchange(stands_at_start_, false)) return action;
    const bool sure = action.kind == Action::Kind::reset && has_to_make_sure();
    const Action first = sure ? safe_step(log_odds, place) : action;
    if (first.kind == Action::Kind::step) ++runs_;
    return first;
  }
  double pace(bool fast) override {
    running_ = fast;
    if (fast) ++runs_;
    return fast ? ladder_.pace() : search_pace_;
  }
  std::optional<MapKind> map_kind() const override { return map_; }

 private:
  /// Whether the next run is to be a safe one.
  bool has_to_make_sure() const {
    constexpr int many_crashes = 3;
    const int crashes = ladder_.crashes_alone();
    return makes_sure_ && crashes > 0 && (runs_ + 1 == most_runs_ || crashes == many_crashes);
  }
  /// A step of the safe run: to the goal by search moves over known walls. At the goal, or without a way, it returns to
  /// speed runs.
  Action safe_step(const LogOddsMap& log_odds, const SearchPlace& place) {
    const Knowledge& known = log_odds.view();
    fields_->ways().fill(known.open(), known.known_cells(), goals_);
    const Action step = fields_->ways().step(place);
    safe_run_ = step.kind == Action::Kind::step && !goals_.contains(place.pose.cell);
    return safe_run_ ? step : Action::reset();
  }
  /// After a speed run the wrapped strategy has no more to do; festina decides on another run.
  Action then(const Action& action) {
    const bool over = action.kind == Action::Kind::forfeit && action.reason == ForfeitReason::finished;
    return running_ && over && ladder_.went_well() ? Action::reset() : action;
  }

  CellSet goals_;
  int most_runs_;
  std::unique_ptr<DriveFields> own_fields_;
  DriveFields* fields_;  ///< own_fields_, or the caller's
  std::unique_ptr<DrivingStrategy> strategy_;
  double usual_pace_;  ///< the caller's pace, as a share of the robot's own; all other paces are relative to it
  double search_pace_, least_pace_;
  double slower_;
  RunLadder ladder_;
  bool makes_sure_;
  MapKind map_;
  int runs_ = 0;          ///< runs begun at the start
  bool running_ = false;  ///< whether the last or present run is a speed run
  bool stands_at_start_ = true;
  bool safe_run_ = false;  ///< whether a safe run is under way
};

std::unique_ptr<DrivingStrategy> drive_festina(const Briefing& briefing, const Settings& settings) {
  const BuiltinMouse& entry = explorer_for(briefing, settings.choice("strategy"));
  const double least = least_pace_of(briefing), pace = std::max(settings.real("search"), least);
  Briefing told = briefing;
  told.drive.pace = briefing.drive.pace * pace;
  std::unique_ptr<DriveFields> fields;
  if (briefing.drive.fields == nullptr) {
    fields = std::make_unique<DriveFields>(DriveFields::in_own_memory(briefing.size, *briefing.drive.model));
    told.drive.fields = fields.get();
  }
  auto strategy = entry.drive(told, Settings(entry.parameters));
  return std::make_unique<Festina>(told, std::move(fields), std::move(strategy), settings, pace, least,
                                   first_run_pace(briefing, settings.real("run")), briefing.drive.pace);
}

}  // namespace

constinit const BuiltinMouse festina_mouse = {
    .name = "festina",
    .summary = "a log-odds map, slower search runs after crashes, faster speed runs from try to try",
    .method =
        "The parameter `strategy` chooses the strategy that explores: ariadne where the time in the maze counts, "
        "certify where it does not. festina itself decides two things, the map and the pace. A log-odds map weighs "
        "contradicting readings; if no route is left, the mouse looks again. The search run begins at the usual pace "
        "and becomes slower after each crash in a search run, because a mouse whose tyres slipped slips again. Speed "
        "runs begin at 0.75 of the usual pace if the rules give a bonus to an untouched mouse, at 0.9 if runs are "
        "few, and otherwise at the usual pace. After a crash, the next speed run is slower by a factor. After a slow "
        "run that finished, the next one is faster. Once there are both, the next run takes the middle of the two, as "
        "long as that is more than a twentieth faster than the last success. If no speed run finished, the last run "
        "that the rules allow, or the one after the third crash, is a safe run: it uses the moves of a search run "
        "over known walls. In worlds without failures all paces are equal, and only the exploring strategy matters.",
    .source = "Search slowly, run faster and faster: what builders of contest mice do by buttons between their runs.",
    .parameters = festina_parameters,
    .drive = drive_festina,
};

}  // namespace labmouse
