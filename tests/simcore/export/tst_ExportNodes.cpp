// SPDX-License-Identifier: GPL-3.0-or-later
// Couplings at picked nodes in files of other programs, with the simulation's cells and with a part's own tetrahedra.
#include <map>
#include <sstream>

#include "tests/scenes/NodeScenes.h"
#include "tests/simcore/export/Exported.h"

namespace glenoid {
namespace {

/// Figure 4 at nodes, with one node less at the left end, so that its picks are no whole face.
Joint pickedJoint() {
  Joint joint = soundJoint();
  joint.couplings = scenes::figure4AtNodes().couplings;
  joint.couplings[0].nodesA.pop_back();
  return joint;
}

/// What stands between quotes behind a key, from a place on.
std::string quotedBehind(const std::string& text, const std::string& key, std::size_t from) {
  const std::size_t at = text.find(key + "=\"", from);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + key.size() + 2;
  return text.substr(begin, text.find('"', begin) - begin);
}

std::vector<double> numbersIn(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> list;
  for (double x; in >> x;) list.push_back(x);
  return list;
}

TEST(ExportNodes, sofaHasASpringAtEachNode) {
  const Joint joint = pickedJoint();
  const Exported file(joint, ExportFormat::Scn);
  const auto springs = numbersIn(quotedBehind(file.text, "spring", file.text.find("name=\"c12\"")));
  ASSERT_EQ(springs.size(), 5 * 8u);
  for (std::size_t s = 0; s < 8; ++s) EXPECT_DOUBLE_EQ(springs[5 * s + 2], joint.couplings[0].stiffnessPerNode);
  // Its ends in the soft part are the nodes.
  const auto ends = numbersIn(quotedBehind(file.text, "position", file.text.find("name=\"springs-c12\"", file.text.find("name=\"middle\""))));
  ASSERT_EQ(ends.size(), 24u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3& node = joint.parts[1].volume->nodes[joint.couplings[0].nodesA[i]];
    EXPECT_LT((Vec3(ends[3 * i], ends[3 * i + 1], ends[3 * i + 2]) - node).norm(), 1e-15);
  }
}

TEST(ExportNodes, febioBondsExactlyTheNodes) {
  const Joint joint = pickedJoint();
  const Exported file(joint, ExportFormat::Feb);
  // Nodes of the file: those of each part in turn, from 1; of "left" its collision surface.
  const long first = 1 + static_cast<long>(joint.parts[0].collision->vertices.size());
  std::vector<long> expected;
  for (const int node : joint.couplings[0].nodesA) expected.push_back(first + node);
  std::sort(expected.begin(), expected.end());
  const std::size_t set = file.text.find("<NodeSet name=\"");
  ASSERT_NE(set, std::string::npos);
  bool found = false;
  for (std::size_t at = set; at != std::string::npos; at = file.text.find("<NodeSet name=\"", at + 1)) {
    const std::size_t begin = file.text.find('>', at) + 1;
    std::string list = file.text.substr(begin, file.text.find("</NodeSet>", at) - begin);
    std::replace(list.begin(), list.end(), ',', ' ');
    std::vector<long> nodes;
    for (const double x : numbersIn(list)) nodes.push_back(static_cast<long>(x));
    std::sort(nodes.begin(), nodes.end());
    found = found || nodes == expected;
  }
  EXPECT_TRUE(found) << "the eight picked nodes of the left end and no other";
  EXPECT_EQ(file.lost(LossKind::CouplingStiffness), 2);
}

TEST(ExportNodes, aPartsOwnTetrahedraAreHeldWhereTheNodesWere) {
  const Joint joint = pickedJoint();
  ExportWish wish;
  wish.mesh = ExportMesh::Conforming;
  const Exported sofa(joint, ExportFormat::Scn, wish);
  const auto springs = numbersIn(quotedBehind(sofa.text, "spring", sofa.text.find("name=\"c12\"")));
  EXPECT_EQ(springs.size(), 5 * 8u);
  const auto ends = numbersIn(quotedBehind(sofa.text, "position", sofa.text.find("name=\"springs-c12\"", sofa.text.find("name=\"middle\""))));
  ASSERT_EQ(ends.size(), 24u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3& node = joint.parts[1].volume->nodes[joint.couplings[0].nodesA[i]];
    EXPECT_LT((Vec3(ends[3 * i], ends[3 * i + 1], ends[3 * i + 2]) - node).norm(), 1e-9) << "a place of the part, whatever its tetrahedra";
  }
  const Exported deck(joint, ExportFormat::Inp);
  EXPECT_EQ(deck.lost(LossKind::CouplingStiffness), 2);
  EXPECT_NE(deck.text.find("NSET=ON-LEFT"), std::string::npos);
}

TEST(ExportNodes, meshesSayWhatTheyLose) {
  const Joint joint = pickedJoint();
  for (const ExportFormat format : {ExportFormat::Msh, ExportFormat::Vtu, ExportFormat::Glb}) EXPECT_EQ(Exported(joint, format).lost(LossKind::Couplings), 2);
  EXPECT_EQ(Exported(joint, ExportFormat::Vtu, "middle").lost(LossKind::Couplings), 0) << "of one part alone there are none";
}

}  // namespace
}  // namespace glenoid
