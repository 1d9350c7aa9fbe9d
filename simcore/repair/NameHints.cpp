// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/NameHints.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace glenoid {
namespace {

struct Size {
  const char* word;
  double metres;
};

/// The first word that is found counts: tissue before the bone that it is named after, long names before what they begin with.
/// A word in capitals stands alone; others may be within one.
constexpr Size kTissues[] = {
    {"ligament", 0.035}, {"labrum", 0.037}, {"menisc", 0.045}, {"capsule", 0.055}, {"discus", 0.025}, {"disc", 0.025}, {"bursa", 0.04},
    {"ACL", 0.035}, {"PCL", 0.038}, {"MCL", 0.1}, {"LCL", 0.06}, {"cartilage", 0.06},
    {"supraspinatus", 0.14}, {"infraspinatus", 0.17}, {"subscapularis", 0.16}, {"teres", 0.14}, {"deltoid", 0.18}, {"biceps", 0.3}, {"triceps", 0.28},
    {"trapezius", 0.4}, {"pectoralis", 0.25}, {"coracobrachialis", 0.18}, {"brachialis", 0.2}, {"quadriceps", 0.4}, {"rectus", 0.35}, {"vastus", 0.35},
    {"gastrocnemius", 0.28}, {"soleus", 0.3}, {"gluteus", 0.25}, {"psoas", 0.3}, {"sartorius", 0.5}, {"gracilis", 0.4}, {"achilles", 0.15}, {"tendon", 0.06}};
constexpr Size kBones[] = {
    {"metacarp", 0.06}, {"metatars", 0.07}, {"phalan", 0.03}, {"carpal", 0.025},
    {"scaphoid", 0.026}, {"lunate", 0.02}, {"triquetr", 0.02}, {"pisiform", 0.014}, {"trapezium", 0.023}, {"trapezoid", 0.019}, {"capitate", 0.027}, {"hamate", 0.024},
    {"talus", 0.055}, {"calcane", 0.08}, {"navicular", 0.04}, {"cuboid", 0.04}, {"cuneiform", 0.03}, {"patella", 0.045}, {"sesamoid", 0.012},
    {"vertebra", 0.08}, {"sacrum", 0.11}, {"coccyx", 0.04}, {"pelvis", 0.28}, {"ilium", 0.2}, {"innominate", 0.22}, {"acetabul", 0.055}, {"HIP", 0.22}, {"RIB", 0.22},
    {"mandib", 0.12}, {"maxilla", 0.08}, {"skull", 0.2}, {"crani", 0.2},
    {"humer", 0.31}, {"scapula", 0.155}, {"glenoid", 0.04}, {"clavic", 0.145}, {"sternum", 0.18}, {"radius", 0.24}, {"RADIAL", 0.24}, {"ulna", 0.26},
    {"femur", 0.45}, {"femor", 0.45}, {"tibia", 0.38}, {"fibula", 0.37}};

/// Words that say that a bone is not whole, or that what lies on it is meant.
constexpr std::array<const char*, 24> kParts{"distal", "proximal", "plateau", "condyl", "epiphys", "metaphys", "diaphys", "shaft", "tubercl", "tuberos", "trochlea", "capitul",
                                             "trochanter", "olecran", "coronoid", "acromi", "coracoid", "styloid", "malleol", "head", "neck", "fragment", "articular", "surface"};

std::string lower(const std::string& text) {
  std::string out = text;
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::vector<std::string> wordsOf(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : lower(name)) {
    if (std::isalpha(static_cast<unsigned char>(c))) words.back() += c;
    else if (!words.back().empty()) words.emplace_back();
  }
  return words;
}

}  // namespace

SizeHint usualSize(const std::string& name) {
  const std::string text = lower(name);
  const std::vector<std::string> words = wordsOf(name);
  const auto named = [&](const Size& size) {
    const std::string plain = lower(size.word);
    const bool alone = size.word[0] >= 'A' && size.word[0] <= 'Z';
    return alone ? std::find(words.begin(), words.end(), plain) != words.end() : text.find(plain) != std::string::npos;
  };
  if (const auto tissue = std::find_if(std::begin(kTissues), std::end(kTissues), named); tissue != std::end(kTissues)) return {tissue->metres, false};
  const auto bone = std::find_if(std::begin(kBones), std::end(kBones), named);
  if (bone == std::end(kBones)) return {};
  // The head of a metacarpal is not told from the whole: both are small.
  return {bone->metres, bone->metres > 0.1 && std::any_of(kParts.begin(), kParts.end(), [&](const char* part) { return text.find(part) != std::string::npos; })};
}

BodySide sideInName(const std::string& name) {
  bool left = false, right = false;
  for (const std::string& word : wordsOf(name)) {
    left = left || word == "l" || word == "left" || word == "lt" || word == "sinister" || word == "sinistra";
    right = right || word == "r" || word == "right" || word == "rt" || word == "dexter" || word == "dextra";
  }
  return left == right ? (left ? BodySide::Both : BodySide::Unknown) : left ? BodySide::Left : BodySide::Right;
}

}  // namespace glenoid
