// SPDX-License-Identifier: GPL-3.0-or-later
/// `generate_tone JOINT`: prints the loads of a resting shoulder as a scenario's "loads". Exit status 0 done, 1 failed, 2
/// usage.
#include <cstdio>

#include "resources/generate/CuffTone.h"
#include "simcore/scene/JointFile.h"

int main(int argc, char** argv) {
  using namespace glenoid;
  if (argc != 2) {
    std::fprintf(stderr, "usage: generate_tone JOINT\n");
    return 2;
  }
  const Result<Joint> joint = loadJoint(argv[1]);
  if (!joint) {
    std::fprintf(stderr, "%s\n", toLogLine(joint.error()).c_str());
    return 1;
  }
  const std::vector<Load> loads = generate::cuffTone(*joint);
  std::printf("  \"loads\": [\n");
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Vec3 &f = loads[i].force_W, &p = *loads[i].point_W;
    std::printf("    {\"part\": \"%s\", \"force\": [%.6g, %.6g, %.6g], \"point\": [%.4g, %.4g, %.4g]}%s\n", loads[i].part.c_str(), f.x(), f.y(),
                f.z(), p.x(), p.y(), p.z(), i + 1 < loads.size() ? "," : "");
  }
  std::printf("  ],\n");
  return 0;
}
