// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// Hand pose of a tool at a moment; between keys positions go linearly and turns by slerp.
struct HandKey {
  double time = 0;  ///< s
  Pose hand;        ///< W
};

/// All keys of one tool, ascending in time; before the first and after the last the pose holds.
struct HandTrack {
  std::string tool;  ///< id
  std::vector<HandKey> keys;
};

/// What a stretch of the run is for, so that a report and a test can speak of it.
struct RecordingMark {
  std::string name;            ///< e.g. "press-biceps-tendon"
  double begin = 0, end = 0;   ///< s
  std::string tool, part;      ///< who presses on whom (ids), may be empty
};

/// Input of a run. One that was recorded also holds what came out, for `replay --check`; a shipped input does not.
struct Recording {
  std::string scenario;        ///< as in the command line
  double dt = 0.005;           ///< s
  std::string profile;         ///< "direct", "paper", "reference"
  unsigned seed = 1;
  long steps = 0;              ///< 0: as long as asked
  std::vector<HandTrack> tracks;
  std::vector<RecordingMark> marks;
  std::string jointHash, build, isa;  ///< of the run, may be empty
  std::string stateHash;       ///< expected at the end, empty in a shipped input
};

/// Hand pose at a time; the track must have at least one key.
Pose handAt(const HandTrack& track, double time);

}  // namespace glenoid
