// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "simcore/scene/Joint.h"
#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"

/// A scene of the shoulder's size without anatomy, on which other simulators have been measured: seven soft
/// blocks hang side by side between a fixed and a moving bone (743 tetrahedra, 411 nodes, 150 bound nodes), a
/// ridge rises under their middle and stays, and a ball presses each in turn. tests/scenes/peers/README.md
/// describes it. Frame W: X from the fixed to the moving bone, Y up, Z across the blocks, origin at the centre of
/// the moving bone, since a hold acts there; m.
///
/// Ridge and ball are driven in the peers. Here they are tools on a coupling so stiff (1e8 N/m) that each step
/// brings them to their hand: 1 kN is 10 µm of lag. Stiffer ones would be cut at the largest force that a scenario
/// may name before a step of 20 ms has brought the ball across.
namespace glenoid::peers {

/// Young's moduli of the blocks: all alike, or one each.
enum class Stiffness { Soft, Firm, Mixed, Tendon };
inline constexpr std::array<Stiffness, 4> kStiffnesses{Stiffness::Soft, Stiffness::Firm, Stiffness::Mixed,
                                                       Stiffness::Tendon};
const char* stiffnessName(Stiffness stiffness);
std::array<double, 7> youngsModuli(Stiffness stiffness);  ///< Pa, by block

inline constexpr int kBlocks = 7;
inline constexpr double kSettleSeconds = 1;      ///< the ridge rises in the first half
inline constexpr double kPressSeconds = 1;       ///< for each block
inline constexpr double kSeconds = kSettleSeconds + kBlocks * kPressSeconds;
inline constexpr double kBallRadius = 0.01;      ///< m
inline constexpr int kBall = 0, kRidge = 1;      ///< tools of the scenario

/// Parts: blocks 0…6, then fixed and moving bone.
Joint makeJoint(Stiffness stiffness);
Scenario makeScenario(double dt);

/// Centre of the ball and height of the ridge's top, W.
Vec3 ballCentre(double time);
double ridgeTop(double time);

/// Hands of both tools that put them there, in the scenario's order.
void handsAt(double time, std::vector<Pose>& hands);

/// The same hands as keys at every `spacing`, with a mark for each press, for a run from files.
Recording makeRecording(double spacing);

}  // namespace glenoid::peers
