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

/// Rules and robot, with those of its parts on which results depend in a world.
std::vector<Condition> drive_conditions(const DriveRules& rules, const DriveModel& model, RobotParts parts);

class DriveWorld : public World {
 public:
  /// `its`: what all these worlds have alike is added.
  DriveWorld(WorldTraits its, const DriveRules& rules, std::shared_ptr<const DriveModel> model);

  std::string refuse(const Maze& maze) const override;
  using World::refuse;
  Settings settings(const Contestant& mouse) const override;
  MazeFacts facts(const Maze& maze) const override;
  ContestOutput hold(const Race& race, ContestResult& result, Keep keep, const std::atomic<bool>* stop) const override;

 protected:
  const DriveRules& rules() const { return rules_; }
  /// Why a mouse does not race by rules that count laps, in which nobody decides; empty where it does.
  std::string refuse_in_laps(const Contestant& mouse) const;
  const DriveModel& model() const { return *model_; }
  /// What the best possible score is, as a sentence.
  std::string bound_words(const Race& race) const;

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
