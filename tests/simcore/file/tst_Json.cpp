// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simcore/file/Json.h"
#include "tests/simcore/file/TemporaryFolder.h"

namespace glenoid {
namespace {

JsonValue parsed(const std::string& text) {
  auto json = parseJson(text, "t");
  EXPECT_TRUE(json.ok()) << text << (json.ok() ? "" : toLogLine(json.error()));
  return json.ok() ? *json : JsonValue();
}

Error faultOf(const std::string& text) {
  const auto json = parseJson(text, "t");
  EXPECT_FALSE(json.ok()) << text.substr(0, 80);
  return json.ok() ? Error{} : json.error();
}

TEST(Json, valuesAreWhatTheTextSays) {
  const JsonValue json = parsed(R"({"a": [1, -2.5, true, null, "\u00e4\n"], "b": {"c": 3}})");
  EXPECT_TRUE(json["a"][0].isInteger());
  EXPECT_EQ(json["a"][0].integer(), 1);
  EXPECT_EQ(json["a"][1].number(), -2.5);
  EXPECT_TRUE(json["a"][2].boolean());
  EXPECT_TRUE(json["a"][3].isNull());
  EXPECT_EQ(json["a"][4].text(), "ä\n");
  EXPECT_EQ(json["b"]["c"].number(), 3);
  EXPECT_TRUE(json["nothing"]["below"][7].isNull());
}

TEST(Json, textComesBackAsTheSameValue) {
  JsonValue json = JsonValue::object();
  JsonValue numbers = JsonValue::array();
  const std::vector<double> values{0.1,       -0.0,   1e-310,      1.7976931348623157e308,
                                   1.0 / 3.0, 5e-324, 123456789.0, 1e22};
  for (const double value : values) numbers.append(value);
  json.set("numbers", numbers);
  json.set("text", std::string("quote \" slash \\ bell \x07 ümlaut \t"));
  json.set("a/b~c", JsonValue::array());
  json.set("integer", static_cast<long long>(std::numeric_limits<std::int64_t>::min()));
  JsonValue rows = JsonValue::array();
  for (int i = 0; i < 40; ++i) {
    JsonValue row = JsonValue::array();
    row.append(i);
    row.append(i * 1000);
    rows.append(row);
  }
  json.set("rows", rows);
  const JsonValue back = parsed(toText(json));
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(back["numbers"][i].number(), values[i]);
    EXPECT_EQ(std::signbit(back["numbers"][i].number()), std::signbit(values[i]));
  }
  EXPECT_EQ(back["text"].text(), json["text"].text());
  EXPECT_TRUE(back["a/b~c"].isArray());
  EXPECT_EQ(back["integer"], json["integer"]);
  EXPECT_EQ(back["rows"], rows);
  EXPECT_EQ(toText(back), toText(json));
}

TEST(Json, linesStayShort) {
  JsonValue list = JsonValue::array();
  for (int i = 0; i < 1000; ++i) list.append(i * 0.125);
  JsonValue json = JsonValue::object();
  json.set("list", list);
  std::istringstream lines(toText(json));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 101u) << line;
}

TEST(Json, syntaxFaultsNameLineAndColumn) {
  const Error error = faultOf("{\n  \"a\": [1, 2,\n    x]\n}");
  EXPECT_EQ(error.fault, Fault::NotJson);
  EXPECT_EQ(error.arguments, (Arguments{"3", "5"}));
  EXPECT_EQ(error.place.pointer, "/a/2");
  EXPECT_EQ(error.place.element, 3);
  for (const char* text : {"{\"a\" 1}", "[1,]", "[1 2]", "{a: 1}", "'a'", "[01]", "[.5]", "nul]", "[1]]",
                           "\xff", "{\"a\":1,}", "[\"\\q\"]", "// comment\n[]", "[\"\t\"]"})
    EXPECT_EQ(faultOf(text).fault, Fault::NotJson) << text;
}

TEST(Json, numbersThatAreNoneAreNamed) {
  for (const char* text :
       {"{\"a\": [0, NaN]}", "{\"a\": [0, nan]}", "{\"a\": [0, Infinity]}", "{\"a\": [0, -Infinity]}",
        "{\"a\": [0, inf]}", "{\"a\": [0, 1e999]}", "{\"a\": [0, -1e999]}"}) {
    const Error error = faultOf(text);
    EXPECT_EQ(error.fault, Fault::NotFinite) << text;
    EXPECT_EQ(error.place.pointer, "/a/1") << text;
  }
  EXPECT_EQ(parsed("[1e-999]")[0].number(), 0);
}

TEST(Json, emptyTruncatedAndDoubled) {
  EXPECT_EQ(faultOf("").fault, Fault::FileEmpty);
  EXPECT_EQ(faultOf(" \n\t ").fault, Fault::FileEmpty);
  const std::string whole = R"({"a": {"b": [1.5, true, "text"]}})";
  for (std::size_t length = 1; length < whole.size(); ++length)
    EXPECT_EQ(faultOf(whole.substr(0, length)).fault, Fault::FileTruncated) << whole.substr(0, length);
  const Error doubled = faultOf(R"({"x": {"a": 1, "b": 2, "a": 3}})");
  EXPECT_EQ(doubled.fault, Fault::DuplicateId);
  EXPECT_EQ(doubled.place.pointer, "/x/a");
  EXPECT_EQ(doubled.arguments, Arguments{"a"});
}

TEST(Json, depthIsBounded) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_TRUE(parseJson(nested(64), "t").ok());
  EXPECT_EQ(faultOf(nested(65)).fault, Fault::TooDeep);
  EXPECT_EQ(faultOf(nested(100000)).fault, Fault::TooDeep);
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(faultOf(objects).fault, Fault::TooDeep);
  EXPECT_EQ(faultOf(std::string(100000, '[')).arguments, Arguments{"64"});
}

TEST(Json, sizeIsBounded) {
  const auto large = parseJson("[1, 2, 3]", "t", {64, 5});
  ASSERT_FALSE(large.ok());
  EXPECT_EQ(large.error().fault, Fault::FileTooLarge);
}

TEST(Json, writingRefusesWhatIsNotFinite) {
  const TemporaryFolder folder;
  folder.put("x.json", "[1]");
  JsonValue json = JsonValue::object();
  JsonValue list = JsonValue::array();
  list.append(1.0);
  list.append(std::numeric_limits<double>::quiet_NaN());
  json.set("list", list);
  const auto written = writeJson(folder.path("x.json"), json);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().fault, Fault::NotFinite);
  EXPECT_EQ(written.error().place.pointer, "/list/1");
  EXPECT_EQ(folder.get("x.json"), "[1]");
}

TEST(JsonValue, pointersFindWhatTheyName) {
  const JsonValue json = parsed(R"({"a/b": {"c~d": [10, 20]}})");
  const std::string pointer = pointerTo(pointerTo(pointerTo("", "a/b"), "c~d"), std::size_t{1});
  EXPECT_EQ(pointer, "/a~1b/c~0d/1");
  ASSERT_TRUE(valueAt(json, pointer));
  EXPECT_EQ(valueAt(json, pointer)->integer(), 20);
  EXPECT_EQ(valueAt(json, ""), &json);
  for (const char* nowhere : {"/x", "/a~1b/c~0d/2", "/a~1b/c~0d/-1", "/a~1b/c~0d/1x", "a", "/a~1b/c~0d/1/2"})
    EXPECT_EQ(valueAt(json, nowhere), nullptr) << nowhere;
}

}  // namespace
}  // namespace glenoid
