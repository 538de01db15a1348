// What the results of contests that are driven have in common, in whatever world.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/races/world_entry.hpp"

namespace labmouse {

std::string outcome_of(const DriveRecord& record, const DriveScore& score);
/// The fastest of the runs that count, from rest to the centre; of laps, from gate to gate.
std::optional<MazeTime> best_of(const DriveScore& score);
/// How much longer the best run took than the fastest possible one, as a share; nothing without a run or if the
/// fastest possible run takes no time.
std::optional<double> excess_of(const std::optional<MazeTime>& best, const DriveBound& bound);
/// In the maze before the first speed run; all of the time where there is none.
MazeTime search_time_of(const DriveRecord& record);
/// Sets the score of a result, and its ratio to the bound.
void add_score(MazeTime value, const DriveBound& bound, const DriveRules& rules, ContestResult& result);

/// Why the robot does not drive in a maze by these rules; empty where it does.
std::string refuse_to_drive_in(const Maze& maze, const DriveRules& rules, const DriveModel& model);
/// A model that shares what all of its contests need.
std::shared_ptr<const DriveModel> sharing_tables(std::shared_ptr<const DriveModel> model);

/// The mean of the bounds.
std::optional<double> mean_bound(const Race& race);
/// How rules score, in words.
std::string formula_of(const DriveRules& rules);

}  // namespace labmouse
