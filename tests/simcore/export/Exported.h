// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include "simcore/export/ExportJoint.h"
#include "tests/simcore/check/Faults.h"
#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {

/// A joint written in one format, and what the file holds.
struct Exported {
  Exported(const Joint& joint, ExportFormat format, const std::string& part = {}) : Exported(joint, format, ExportWish{part, {}, {}, {}}) {}
  Exported(const Joint& joint, ExportFormat format, const ExportWish& wish) {
    auto done = exportJoint(joint, format, folder.path("x"), wish);
    EXPECT_TRUE(done.ok()) << toLogLine(done.error());
    if (done.ok()) report = *done;
    text = folder.get("x");
  }
  long lost(LossKind kind) const {
    for (const Loss& loss : report.losses)
      if (loss.kind == kind) return loss.count;
    return 0;
  }
  TemporaryFolder folder;
  ExportReport report;
  std::string text;
};

/// Bone – tissue – bone with a cage that has moved, a bursa, odd names and thirds that need all digits.
inline Joint richJoint() {
  Joint joint = soundJoint();
  joint.name = "A <joint> & \"more\" — Schulter";
  joint.parts[0].name = "Left <bone>";
  joint.materials[1].youngsModulus = 1e5 / 3;
  joint.parts[0].regions.push_back({"face", "Face", "other", SurfaceKind::Visual, {{0, 2}}});
  joint.parts[0].landmarks.push_back({"tip", "Tip", Vec3(0, 0, 0)});
  Bursa bursa;
  bursa.id = "sac";
  bursa.floor = {{joint.parts[0].id, ""}};
  bursa.roof = {{joint.parts[2].id, ""}};
  joint.bursae = {bursa};
  joint.cages = {boxCage(softPart(joint), 2e-3)};
  for (Vec3& handle : joint.cages[0].moved_W) handle.y() += 1e-3;
  return joint;
}

}  // namespace glenoid
