// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/MaterialLibrary.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace glenoid {
namespace {

TEST(MaterialLibrary, shippedTissuesHaveTheirSources) {
  const std::string path = GLENOID_SOURCE_DIR "/resources/materials/tissues.json";
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto library = parseMaterialLibrary(text, path);
  ASSERT_TRUE(library.ok()) << toLogLine(library.error());
  EXPECT_GE(library->size(), 16u);
  for (const Material& material : *library) {
    EXPECT_FALSE(material.source.empty()) << material.id;
    EXPECT_FALSE(material.name.empty()) << material.id;
    EXPECT_EQ(material.literatureYoungsModulus.has_value(), !material.reason.empty()) << material.id;
    EXPECT_LE(material.poissonRatio, 0.45) << material.id << ": linear tetrahedra lock near 0.5";
  }
}

TEST(MaterialLibrary, badOnesSayWhere) {
  const auto fault = [](const char* text) { return parseMaterialLibrary(text, "tissues.json").error(); };
  EXPECT_EQ(fault("").fault, Fault::FileEmpty);
  EXPECT_EQ(fault("[1, 2]").fault, Fault::SchemaMismatch);
  EXPECT_EQ(fault(R"({"schemaVersion": 1})").fault, Fault::SchemaMismatch);
  EXPECT_EQ(fault(R"({"schemaVersion": 99, "materials": []})").fault, Fault::NewerSchema);
  const char* heavy = R"({"schemaVersion": 1, "materials": [{"id": "a", "density": -1, "youngsModulus": 1, "poissonRatio": 0}]})";
  EXPECT_EQ(fault(heavy).fault, Fault::OutOfRange);
  EXPECT_EQ(fault(heavy).place.pointer, "/materials/0/density");
  const char* twice = R"({"schemaVersion": 1, "materials": [
    {"id": "a", "density": 1, "youngsModulus": 1, "poissonRatio": 0}, {"id": "a", "density": 1, "youngsModulus": 1, "poissonRatio": 0}]})";
  EXPECT_EQ(fault(twice).fault, Fault::DuplicateId);
}

}  // namespace
}  // namespace glenoid
