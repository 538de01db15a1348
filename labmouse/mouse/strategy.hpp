// The interface of every mouse.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/belief.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/reasons.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// A number that a mind keeps about its own work, for records: "nodes found".
struct Counter {
  std::string_view name;
  std::int64_t value = 0;
};

/// A mind. It is called and never calls, so one object serves a loop, a browser frame and an interrupt.
class Strategy {
 public:
  virtual ~Strategy() = default;

  /// The next action, given what is read in the present pose. Called once a step until the contest ends.
  virtual Action decide(const Sighting& seen) = 0;

  /// Shows it a reading in a pose in which it does not decide: in a cell that its last step leads through, or on a way
  /// on which others drive it.
  virtual void show(const Pose&, const Sighting&) {}

  /// It stands at the start as in the beginning, so many microseconds after the contest began: a hand carried it there,
  /// or it has not come away from there, for want of a way; for minds in seconds alone.
  virtual void carried(std::int64_t) {}

  /// Whether it can think about walls that are not what they were taken for: then it is asked by consider() alone,
  /// where its map may change its mind.
  virtual bool considers() const { return false; }
  /// The next action, in place of decide(), by what a map that readings have already come to believes now: where the
  /// mouse is, and so many microseconds after the contest began.
  virtual Action consider(const Belief&, const SearchPlace&, std::int64_t) {
    return Action::forfeit(ForfeitReason::contradiction);
  }

  /// At which part of its usual pace it wants to be driven, up to 1: asked as a run begins that is a fast one over
  /// known walls, or else a search or a way home. Only worlds in which things go wrong listen to it.
  virtual double pace(bool /*fast*/) { return 1.0; }
  /// From now on it searches at that part of the robot's own pace, other than its briefing says; for minds in seconds.
  virtual void searches_at(double) {}
  /// What its map does with readings against it; without an answer the conditions of the contest say so.
  virtual std::optional<MapKind> map_kind() const { return std::nullopt; }

  /// What the mouse believes, for viewers and for the contract tests.
  virtual const Knowledge& knowledge() const = 0;

  /// What it counted so far, under names that never change.
  virtual std::span<const Counter> counters() const { return {}; }

  /// What it has to say at the end, for people: where it gave up, what went wrong, in the first line; then of a guest
  /// the last lines that it wrote to its standard error.
  virtual std::string_view last_words() { return {}; }

  /// The microseconds that its decisions took, known after last_words(), where it measures them itself: a mouse in
  /// another process does, and leaves out the way there and back.
  virtual std::optional<double> microseconds() const { return std::nullopt; }

  /// Whether it can be asked at all: false of a guest whose program did not start, or ended before it greeted.
  virtual bool started() const { return true; }

  /// Asks it to keep its reasons, before the first decision. Most minds have none to tell.
  virtual void keep_reasons() {}
  /// The reasons of the last decision, where it chose anew and was asked to keep them; else null.
  virtual const Reasons* reasons() const { return nullptr; }
};

}  // namespace labmouse
