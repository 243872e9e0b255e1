// Strict JSON: what is read, on which line, and every refusal with its whole text.
#include "host/json.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/refusal.h"

namespace relume {
namespace {

std::string parse_error(const std::string& text) {
  return error_of([&] { parse_json(text, "a.json"); });
}

TEST(Json, KeepsValuesOrderAndLines) {
  const Json json =
      parse_json("\xef\xbb\xbf{\n  \"b\": [1,\n 2.5,\n -3e2],\n \"a\": {\"t\": true, \"n\": null},\n\"s\"\n:\n\"x\\u00e9\\n\"\n}\n", "a.json");
  ASSERT_EQ(json.type, Json::Type::object);
  ASSERT_EQ(json.members.size(), 3u);
  EXPECT_EQ(json.line, 1);
  EXPECT_EQ(json.members[0].key, "b");
  EXPECT_EQ(json.members[0].line, 2);
  const std::vector<Json>& numbers = json.members[0].value.items;
  ASSERT_EQ(numbers.size(), 3u);
  EXPECT_EQ(numbers[0].number, 1);
  EXPECT_EQ(numbers[0].line, 2);
  EXPECT_EQ(numbers[1].number, 2.5);
  EXPECT_EQ(numbers[1].line, 3);
  EXPECT_EQ(numbers[2].number, -300);
  EXPECT_EQ(numbers[2].line, 4);
  EXPECT_TRUE(json.find("a")->find("t")->boolean);
  EXPECT_EQ(json.find("a")->find("n")->type, Json::Type::null);
  EXPECT_EQ(json.find("a")->line, 5);
  EXPECT_EQ(json.members[2].line, 6);
  EXPECT_EQ(json.find("s")->line, 8);
  EXPECT_EQ(json.find("s")->string, "x\u00e9\n");
  EXPECT_EQ(json.find("z"), nullptr);
}

TEST(Json, ANumberThatEndsALineStandsOnThatLine) {
  const Json json = parse_json("[\n1\n,\n2\n]", "a.json");
  EXPECT_EQ(json.items[0].line, 2);
  EXPECT_EQ(json.items[1].line, 4);
  EXPECT_EQ(parse_json("\n7", "a.json").line, 2);
}

TEST(Json, RefusesWhatIsNotJson) {
  EXPECT_EQ(parse_error("{\"a\": 1,\n \"b\": 2,\n \"a\": 3}"), "a.json:3: key \"a\" is given twice");
  EXPECT_EQ(parse_error("[1]\n\n]"), "a.json:3: not JSON: unexpected ']'; expected end of input");
  EXPECT_EQ(parse_error("[\n1e999\n]"), "a.json:2: number 1e999 is beyond the range of a double");
  EXPECT_EQ(parse_error("[\n\"\xff\"]"), "a.json:2: not valid UTF-8");
  EXPECT_EQ(parse_error("[ // why\n1]"), "a.json:1: comments are not allowed in JSON");
  EXPECT_EQ(parse_error("\n# why\n[1]"), "a.json:2: comments are not allowed in JSON");
  EXPECT_EQ(parse_error("[NaN]"), "a.json:1: not JSON: invalid literal; last read: '[N'");
  EXPECT_EQ(parse_error("{\"a\": 1,\n}"), "a.json:2: not JSON: unexpected '}'; expected string literal");
  EXPECT_EQ(parse_error(""), "a.json:1: not JSON: unexpected end of input; expected '[', '{', or a literal");
  EXPECT_EQ(parse_error("{\"a\": \n"), "a.json:1: not JSON: unexpected end of input; expected '[', '{', or a literal");
  EXPECT_EQ(parse_error(std::string(65, '[') + std::string(65, ']')), "a.json:1: nested too deeply (64 levels are allowed)");
  EXPECT_EQ(parse_error(std::string(64, '[') + std::string(64, ']')), "no error");
  EXPECT_EQ(parse_error(std::string(1000000, '[')), "a.json:1: nested too deeply (64 levels are allowed)");
}

TEST(Json, EveryErrorIsOneLine) {
  for (const char* text : {"[\"a\nb\"]", "[\"\\x\"]", "[\"\x01\"]", "tru\ne", "{\"a\n\": 1}", "{\"a\" 1}", "[01]", "[1,]", "[.5]", "[+1]", "['a']"}) {
    const std::string error = parse_error(text);
    EXPECT_TRUE(error.starts_with("a.json:1: not JSON: ")) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(ObjectReader, SaysWhatIsWrongAndWhere) {
  const Json json = parse_json(R"({"relume": 2,
    "cone": "round", "range": "far", "colour": [1, 2],
    "mixed": [1, "x", 3], "on": 1, "name": false, "list": [], "grey": 0.5})",
                               "rig.json");
  const ObjectReader reader(json, "rig.json", "lights[3]");
  const auto error = [&](auto action) { return error_of([&] { action(); }); };
  EXPECT_EQ(error([&] {
              reader.choice("cone", {"gltf", "smoothstep", "linear"});
            }),
            "rig.json:2: lights[3]: \"cone\": must be one of gltf, smoothstep, linear");
  EXPECT_EQ(error([&] { reader.number("range"); }), "rig.json:2: lights[3]: \"range\": must be a number (is a string)");
  EXPECT_EQ(error([&] {
              reader.allow({"relume", "cone", "range", "type"});
            }),
            "rig.json:2: lights[3]: unknown key \"colour\" (has: relume, cone, range, type)");
  EXPECT_EQ(error([&] { reader.numbers("colour", 3); }), "rig.json:2: lights[3]: \"colour\": must be 3 numbers (has 2)");
  EXPECT_EQ(error([&] { reader.numbers("mixed", 3); }), "rig.json:3: lights[3]: \"mixed\": must be 3 numbers (is a string)");
  EXPECT_EQ(error([&] { reader.numbers("grey", 3); }), "rig.json:3: lights[3]: \"grey\": must be 3 numbers (is a number)");
  EXPECT_EQ(error([&] { reader.numbers("name", 3, true); }), "rig.json:3: lights[3]: \"name\": must be 1 or 3 numbers (is a boolean)");
  EXPECT_EQ(error([&] { reader.boolean("on"); }), "rig.json:3: lights[3]: \"on\": must be true or false (is a number)");
  EXPECT_EQ(error([&] { reader.string("name"); }), "rig.json:3: lights[3]: \"name\": must be a string (is a boolean)");
  EXPECT_EQ(error([&] { reader.need("type"); }), "rig.json:1: lights[3]: \"type\" is missing");
  EXPECT_EQ(error([&] { reader.need_version(); }), "rig.json:1: lights[3]: \"relume\": this version of the file is not known (1 is)");
  EXPECT_EQ(error([&] { ObjectReader(*json.find("list"), "rig.json", "camera"); }), "rig.json:3: camera: must be an object (is an array)");
  EXPECT_EQ(reader.numbers("grey", 3, true), (std::vector<double>{0.5, 0.5, 0.5}));
  EXPECT_EQ(reader.number("absent"), std::nullopt);
  EXPECT_EQ(reader.boolean("absent"), std::nullopt);
  EXPECT_EQ(reader.string("absent"), std::nullopt);
  EXPECT_EQ(reader.choice("absent", {"a"}), std::nullopt);
}

TEST(Json, QuotesStayOnOneLine) {
  EXPECT_EQ(in_quotes("a\nb\"c"), "\"a\\nb\\\"c\"");
  EXPECT_EQ(in_quotes("\xff"), "\"\xef\xbf\xbd\"");  // the replacement character
  EXPECT_EQ(in_digits(0.1), "0.1");
  EXPECT_EQ(in_digits(10000), "10000");
  EXPECT_EQ(in_digits(0.0001), "0.0001");
  EXPECT_EQ(in_digits(-1e300), "-1e+300");
}

TEST(ReadText, NamesTheFile) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  EXPECT_EQ(error_of([&] { read_text(folder); }), folder.string() + ": is a directory");
  EXPECT_EQ(error_of([&] { read_text(folder / "not_there.json"); }), (folder / "not_there.json").string() + ": no such file");
}

TEST(ReadText, ADashIsStandardInput) {
  const StandardInput input("[1]\n");
  EXPECT_EQ(read_text("-"), "[1]\n");
  EXPECT_EQ(shown("-"), "standard input");
  EXPECT_EQ(shown("a/b.json"), "a/b.json");
}

}  // namespace
}  // namespace relume
