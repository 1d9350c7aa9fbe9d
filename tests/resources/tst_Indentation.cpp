// SPDX-License-Identifier: GPL-3.0-or-later
// What a tip at 2 N sinks into each tissue, against a separate fine static solve of the part.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "tests/resources/Indentation.h"
#include "tests/resources/ShoulderSizes.h"

namespace glenoid::test {
namespace {

const std::vector<PressedTissue> kTissues = {
    {"supraspinatus", "-tendon,origin,insertion"},  {"supraspinatus", "tendon"}, {"infraspinatus", "-tendon,origin,insertion"},
    {"infraspinatus", "tendon"},                    {"subscapularis", "-tendon,origin,insertion"},
    {"subscapularis", "tendon"},                    {"coracoacromial-ligament", ""},
    {"coracohumeral-ligament", ""},                 {"labrum", "-base"},         {"labrum-tendon", ""}};

TEST(Indentation, table) {
  const Joint& joint = shippedShoulder();
  for (const PressedTissue& tissue : kTissues) {
    const int index = findPart(joint, tissue.part);
    const Part& part = joint.parts[index];
    const TipPatch patch = tipPatchAt(*part.visual, middleOf(part, tissue.region), 1.5e-3);
    const auto begin = std::chrono::steady_clock::now();
    const double fine = fineIndentation(joint, tissue.part, patch, false);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double finer = fineIndentation(joint, tissue.part, patch, true);
    const StaticPart coarse = StaticPart::make(joint, index, part.volume, TetFilling::Partial).value();
    const double stiff = 2 * coarse.compliance(patch);
    const Pressed hard = pressWithTip(joint, tissue.part, patch, Wish::Off), soft = pressWithTip(joint, tissue.part, patch, Wish::Auto);
    std::printf("%-26s %-10.10s fine %7.3f finer %7.3f (%4.1f %%, %.1f s) coarse static %7.3f; run hard %7.3f (%.2f N, drift %.2f, %d) "
                "dented %7.3f (%.2f N, dent %.2f, drift %.2f, %d) mm\n",
                tissue.part.c_str(), tissue.region.c_str(), 1e3 * fine, 1e3 * finer, 100 * (finer / fine - 1), seconds, 1e3 * stiff,
                1e3 * hard.travel, hard.force, 1e3 * hard.drift, hard.settled, 1e3 * soft.travel, soft.force, 1e3 * soft.dent,
                1e3 * soft.drift, soft.settled);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace glenoid::test
