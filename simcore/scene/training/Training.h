// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/Math.h"

/// What somebody is to do in a scenario, and how it is scored: plain values that an instructor writes, ids refer. SI units,
/// frame W at rest. What a run makes of them: simcore/train.
namespace glenoid {

enum class TaskKind {
  Touch,   ///< press a place with at least forceMin for `hold`
  Press,   ///< keep the force between forceMin and forceMax for `hold` without a break
  Look,    ///< keep a place in sight, `angle` or nearer to the middle of the view, for `hold`
  Trace,   ///< draw the tip along the places in their order without letting go
  Follow,  ///< keep the tip within `tolerance` of a place that moves along `keys`
  Find,    ///< say where a hidden place is by pressing there and standing still for `hold`
  Pass,    ///< take the tip through rings around the places, in their order
};

/// A place on a part: of a landmark, of a point at rest, or anywhere on a region or on the whole part. Without a part a
/// point stands still in the room.
struct TaskPlace {
  std::string part;                 ///< id; empty: the room, and then there is a point
  std::string landmark, region;     ///< ids of the part; at most one of landmark, region and point
  std::optional<Vec3> point_W;      ///< m, at rest: a material point of the part
  std::optional<Vec3> normal_W;     ///< Pass only: along which the tip goes through the ring; turns with the part
  bool operator==(const TaskPlace&) const = default;
};

/// Where the place of a Follow task is, beside where it was at the beginning.
struct FollowKey {
  double time = 0;                  ///< s since the tip first came near
  Vec3 displacement_W = Vec3::Zero();  ///< m
  bool operator==(const FollowKey&) const = default;
};

struct Task {
  std::string id;                   ///< slug, unique among the tasks
  std::string name, text, hint;     ///< shown to people: a title, what to do, and what helps
  TaskKind kind = TaskKind::Touch;
  std::string tool;                 ///< id of the tool that does it; empty: any that a hand holds (Look: any arthroscope)
  std::vector<TaskPlace> places;    ///< one; Trace two or more, Pass one or more
  std::vector<FollowKey> keys;      ///< Follow: ascending in time; none: the place stays
  double tolerance = 0.005;         ///< m: how far from the place still counts; Pass: radius of the rings
  double hold = 0.5;                ///< s
  double forceMin = 0.1;            ///< N
  std::optional<double> forceMax;   ///< N: beyond it a Press is broken off and a Touch or Trace has an error
  double angle = 0.25;              ///< rad, Look
  double range = 0.06;              ///< m, Look: farther away nothing is recognised
  double share = 0.8;               ///< Follow: part of the time that the tip must be near
  double timeGood = 0;              ///< s: slower scores less, in proportion; 0: time does not count
  double timeMax = 0;               ///< s: then the task is missed; 0: none
  double errorCost = 0.25;          ///< of the task's score for each error
  double weight = 1;                ///< among the tasks
  bool hidden = false;              ///< its place is not shown before the end (Find)
  bool operator==(const Task&) const = default;
};

/// A structure that must not be pressed too hard, by any tool, whatever the task.
struct ForceLimit {
  std::string id, name;
  std::string part, region;         ///< region: only contacts on it count; empty: the whole part
  double forceMax = 1;              ///< N
  bool operator==(const ForceLimit&) const = default;
};

/// A row of the form that makes the score: points in full at `best`, none at `worst`, in proportion between.
struct FormRow {
  std::string metric;               ///< name of a metric (simcore/train/Metric.h)
  double points = 0, best = 0, worst = 1;
  bool operator==(const FormRow&) const = default;
};

/// What others reached, to say how far from them somebody is: z = (value − mean) / sd.
struct ReferenceFigure {
  std::string metric;
  double mean = 0, sd = 1;
  int count = 0;                    ///< of runs
  std::string source;
  bool operator==(const ReferenceFigure&) const = default;
};

/// A published limit, with whom it was found for: shown beside the value, never part of the score.
struct Benchmark {
  std::string metric;
  double limit = 0;                 ///< at most
  std::string name, source;
  bool operator==(const Benchmark&) const = default;
};

struct Training {
  std::string text;                 ///< shown before the first task
  bool ordered = false;             ///< one task after the other, else in any order
  std::vector<Task> tasks;          ///< none: no training
  std::vector<ForceLimit> limits;
  std::vector<FormRow> form;        ///< none: kDefaultForm
  double passScore = 70;            ///< of the form's points
  std::vector<ReferenceFigure> references;
  std::vector<Benchmark> benchmarks;
  bool operator==(const Training&) const = default;
};

/// The form of a training without one: 80 points for what was done, 20 for doing it without errors (none from five on).
std::vector<FormRow> defaultForm();

/// Takes out what refers to a part, or only to a region of it: places, and tasks that have too few left; limits.
void dropFromTraining(Training& training, const std::string& part, const std::string& region = {});

}  // namespace glenoid
