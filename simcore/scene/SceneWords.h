// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>

#include "simcore/embed/Cells.h"
#include "simcore/scene/JointSide.h"
#include "simcore/scene/Material.h"
#include "simcore/scene/Scenario.h"

/// Words of the files for what is an enum in memory; shared by the files of this folder.
namespace glenoid::scene_words {

template <class Enum>
struct Word {
  Enum value;
  const char* word;
};

inline constexpr std::array<Word<Profile>, 3> kProfiles{
    {{Profile::Paper, "paper"}, {Profile::Direct, "direct"}, {Profile::Reference, "reference"}}};
inline constexpr std::array<Word<Elements>, 2> kElements{{{Elements::Tetrahedra, "tetrahedra"}, {Elements::Cells, "cells"}}};
inline constexpr std::array<Word<JointSide>, 2> kJointSides{{{JointSide::Left, "left"}, {JointSide::Right, "right"}}};
inline constexpr std::array<Word<GridAxes>, 3> kGridAxes{{{GridAxes::World, "world"}, {GridAxes::Principal, "principal"}, {GridAxes::Band, "band"}}};
inline constexpr std::array<Word<Wish>, 3> kWishes{{{Wish::Auto, "auto"}, {Wish::On, "on"}, {Wish::Off, "off"}}};
inline constexpr std::array<Word<Appearance>, 7> kAppearances{{{Appearance::Plain, "plain"},
                                                                {Appearance::Bone, "bone"},
                                                                {Appearance::Cartilage, "cartilage"},
                                                                {Appearance::Muscle, "muscle"},
                                                                {Appearance::Tendon, "tendon"},
                                                                {Appearance::Ligament, "ligament"},
                                                                {Appearance::Skin, "skin"}}};
inline constexpr std::array<Word<ToolKind>, 5> kToolKinds{{{ToolKind::Probe, "probe"},
                                                           {ToolKind::Arthroscope, "arthroscope"},
                                                           {ToolKind::Finger, "finger"},
                                                           {ToolKind::Ball, "ball"},
                                                           {ToolKind::Bar, "bar"}}};

template <class Table, class Enum>
const char* wordOf(const Table& table, Enum value) {
  for (const auto& entry : table)
    if (entry.value == value) return entry.word;
  return "";
}

/// Documents that fit their schema hold no other word; an absent member leaves the default.
template <class Table, class Enum>
Enum valueOf(const Table& table, const std::string& word, Enum otherwise) {
  for (const auto& entry : table)
    if (word == entry.word) return entry.value;
  return otherwise;
}

/// Name and member of every axis.
struct AxisWord {
  const char* word;
  bool Axes::*axis;
};
inline constexpr std::array<AxisWord, 3> kAxes{{{"x", &Axes::x}, {"y", &Axes::y}, {"z", &Axes::z}}};

/// Name and member of every effect, in the order of the file.
struct EffectWord {
  const char* word;
  Wish Effects::*wish;
};
inline constexpr std::array<EffectWord, 9> kEffects{{{"gravity", &Effects::gravity},
                                                     {"couplings", &Effects::couplings},
                                                     {"contact", &Effects::contact},
                                                     {"selfContact", &Effects::selfContact},
                                                     {"friction", &Effects::friction},
                                                     {"damping", &Effects::damping},
                                                     {"bursa", &Effects::bursa},
                                                     {"dent", &Effects::dent},
                                                     {"haptics", &Effects::haptics}}};

}  // namespace glenoid::scene_words
