// SPDX-License-Identifier: GPL-3.0-or-later
/// `generate_shoulder OUT.joint`: writes the shoulder that ships. Same program, same bytes. Exit status 0
/// done, 1 the joint could not be built or written, 2 usage.
#include <cstdio>

#include "resources/generate/Shoulder.h"
#include "simcore/scene/JointFile.h"

int main(int argc, char** argv) {
  const std::string layers = argc == 3 ? argv[2] : "deep";
  if (argc < 2 || argc > 3 || (layers != "deep" && layers != "superficial" && layers != "capsule")) {
    std::fprintf(stderr, "usage: generate_shoulder OUT.joint [deep|superficial|capsule]\n");
    return 2;
  }
  const glenoid::Result<glenoid::Joint> joint =
      layers == "deep"      ? glenoid::generate::makeShoulder()
                                                   : layers == "capsule" ? glenoid::generate::makeWithCapsule()
                                                                         : glenoid::generate::makePalpation();
  if (!joint) {
    std::fprintf(stderr, "%s\n", glenoid::toLogLine(joint.error()).c_str());
    return 1;
  }
  if (const auto saved = glenoid::saveJoint(*joint, argv[1]); !saved) {
    std::fprintf(stderr, "%s\n", glenoid::toLogLine(saved.error()).c_str());
    return 1;
  }
  for (const glenoid::Part& part : joint->parts)
    std::printf("%2d %-28s %6zu %5zu %5zu\n", part.number, part.id.c_str(), part.visual->triangles.size(),
                part.collision->triangles.size(), part.volume ? part.volume->tets.size() : 0);
  return 0;
}
