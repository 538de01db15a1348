// What the worlds in which robots drive have in common.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/lab/drive/drive_figures.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// A contest as it was driven.
struct DrivenContest {
  DriveRecord record;
  std::optional<PhysicalPart> physical;  ///< in worlds with errors
  std::optional<Coverage> coverage;      ///< nothing for an external controller, whose map is unknown
  std::string words;
  bool started = true;
};

class DriveWorld : public World {
 public:
  DriveWorld(const DriveRules& rules, std::shared_ptr<const DriveModel> model);

  std::string formula() const override;
  std::string refuse(const Maze& maze) const override;
  using World::refuse;
  Settings settings(const Contestant& mouse) const override;
  std::string_view unit() const override { return unit_of(rules_.counts); }
  MazeFacts facts(const Maze& maze) const override;
  ContestOutput hold(const Race& race, ContestResult& result, Keep keep, const std::atomic<bool>* stop) const override;
  double limit_score() const override;
  std::string_view tie_breaker() const override { return "search_us"; }
  ScorePlace score_place() const override;
  std::string_view why_no_bound() const override { return "in which no mouse could score"; }

 protected:
  const DriveRules& rules() const { return rules_; }
  /// Why a mouse does not race by rules that count laps, in which nobody decides; empty where it does.
  std::string refuse_in_laps(const Contestant& mouse) const;
  bool counts_dead_ends() const { return rules_.counts == Counted::dead_end; }
  const DriveModel& model() const { return *model_; }
  /// What the best possible score is, as a sentence.
  std::string bound_words(const Race& race) const;
  /// Rules and robot, with those of its parts on which results depend in this world.
  std::vector<Condition> drive_conditions(RobotParts parts) const;

  /// Runs the contest. `reachable`: the cells of the maze that a mouse can reach; `traced`: whether to keep where it
  /// was between its moves, for a record or a picture.
  virtual DrivenContest drive(const Contestant& mouse, const Maze& maze, const ContestResult& contest,
                              const CellSet& reachable, bool traced, const std::atomic<bool>* stop) const = 0;
  /// The figures of a contest, without those that all these worlds have.
  virtual std::shared_ptr<DriveFigures> own_figures(const DrivenContest& driven, const DriveScore& score) const = 0;

 private:
  ContestOutput kept(const Contestant& mouse, const NamedMaze& maze, std::uint64_t seed, DrivenContest driven,
                     Keep keep) const;

  DriveRules rules_;
  std::shared_ptr<const DriveModel> model_;
};

}  // namespace labmouse
