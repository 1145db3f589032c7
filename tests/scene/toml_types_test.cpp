// Every key of every table of a scene file with values of every wrong type: an error at its line.
#include <rayscope/settings.h>

#include <algorithm>
#include <set>

#include "scene_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Values of all types, and edges of types.
const std::vector<std::string> kValues{"true",
                                       "4",
                                       "4.5",
                                       "-4",
                                       "\"text\"",
                                       "\"\"",
                                       "\"4\"",
                                       "\"true\"",
                                       "nan",
                                       "inf",
                                       "-inf",
                                       "1e39",
                                       "-1e39",
                                       "[]",
                                       "[1]",
                                       "[1, 2]",
                                       "[1.5, 2.5]",
                                       "[1, 2, 3, 4]",
                                       "[nan, 0, 0]",
                                       "[0, 0, inf]",
                                       "[1e39, 0, 0]",
                                       "[true, 0, 0]",
                                       "[\"a\", \"b\", \"c\"]",
                                       "[[0, 0, 0]]",
                                       "{}",
                                       "{ x = 1 }",
                                       "1979-05-27",
                                       "07:32:00",
                                       "1979-05-27T07:32:00Z"};

/// What a key accepts among kValues.
struct Kind {
    std::set<std::string> accepted;
};
const Kind kNothing{};  // vectors, colours, paths, choices, names: none of the values fits
const Kind kText{{"\"text\"", "\"\"", "\"4\"", "\"true\""}};
const Kind kNumber{{"4", "4.5", "-4"}};
const Kind kPositive{{"4", "4.5"}};
const Kind kInteger{{"4"}};
const Kind kBoolean{{"true"}};
const Kind kSize{{"[1, 2]", "[1.5, 2.5]"}};
const Kind kCells{{"[1, 2]"}};
const Kind kTable{{"{}"}};

struct Key {
    std::string name;
    Kind kind;
};

/// A table: the text before and behind its keys, a separator, keys that must be there, and all its keys.
struct Table {
    std::string before, after, separator;
    std::vector<std::pair<std::string, std::string>> others;
    std::vector<Key> keys;
};

Table section(const std::string& header, std::vector<std::pair<std::string, std::string>> others,
              std::vector<Key> keys) {
    return {header + "\n", "", "\n", std::move(others), std::move(keys)};
}
Table inlined(const std::string& before, std::vector<std::pair<std::string, std::string>> others,
              std::vector<Key> keys, const std::string& after = " }") {
    return {before, after, ", ", std::move(others), std::move(keys)};
}

Table shape(const std::string& name, std::vector<Key> keys) {
    keys.push_back({"shape", kNothing});
    return inlined("[[mesh]]\ngenerate = { ", {{"shape", "\"" + name + "\""}}, std::move(keys));
}
Table lightTable(const std::string& type, std::vector<std::pair<std::string, std::string>> others,
                 std::vector<Key> keys) {
    others.insert(others.begin(), {"type", "\"" + type + "\""});
    keys.push_back({"type", kNothing});
    keys.push_back({"falloff", kNothing});
    return section("[[light]]", std::move(others), std::move(keys));
}

std::vector<Table> shapeTables() {
    return {
        shape("quad", {{"size", kSize}}),
        shape("box", {{"size", kNothing}, {"inward", kBoolean}}),
        shape("uv_sphere", {{"radius", kPositive}, {"segments", kInteger}, {"rings", kInteger}}),
        shape("icosphere", {{"radius", kPositive}, {"subdivisions", kInteger}}),
        shape("torus", {{"radius", kPositive},
                        {"tube_radius", kPositive},
                        {"segments", kInteger},
                        {"tube_segments", kInteger}}),
        shape("terrain", {{"size", kSize}, {"height", kPositive}, {"cells", kCells}, {"seed", kInteger}}),
        shape("teapot", {{"resolution", kInteger}}),
        shape("monkey", {{"resolution", kNothing}}),
    };
}

std::vector<Table> objectTables() {
    return {
        section("[[camera]]", {{"look_from", "[0, 0, 3]"}},
                {{"name", kText},
                 {"look_from", kNothing},
                 {"look_at", kNothing},
                 {"up", kNothing},
                 {"fov", kPositive},
                 {"lens", kTable}}),
        inlined("[[camera]]\nlook_from = [0, 0, 3]\nlens = { ", {},
                {{"f_number", kPositive}, {"focal_length", kPositive}, {"focus_distance", kPositive}}),
        section("[[mesh]]", {{"generate", "{ shape = \"quad\" }"}},
                {{"name", kText},
                 {"file", kNothing},
                 {"generate", kNothing},
                 {"transform", kTable},
                 {"material", kNothing},
                 {"motion", kNothing},
                 {"vertex_colors", kBoolean},
                 {"if_missing", kText}}),
        inlined("[[mesh]]\ngenerate = { shape = \"quad\" }\ntransform = { ", {},
                {{"scale", kPositive}, {"rotate", kNothing}, {"translate", kNothing}, {"matrix", kNothing}}),
        section("[[sphere]]", {{"center", "[0, 0, 0]"}, {"radius", "1"}},
                {{"name", kText},
                 {"center", kNothing},
                 {"radius", kPositive},
                 {"material", kNothing},
                 {"motion", kNothing}}),
        section("[material.m]", {},
                {{"kd", kNothing},
                 {"ks", kNothing},
                 {"shininess", kPositive},
                 {"opacity", kNothing},
                 {"illum", kInteger},
                 {"kd_texture", kNothing}}),
        inlined("[material.m]\nkd = { ", {}, {{"srgb", kNothing}}),
        inlined("[material.m]\nkd_texture = { ", {{"file", "\"none.png\""}},
                {{"file", kNothing}, {"wrap", kNothing}}),
        inlined("[material.m]\nkd_texture = { ", {{"generate", "\"checker\""}},
                {{"generate", kNothing},
                 {"wrap", kNothing},
                 {"cells", kCells},
                 {"colors", kNothing},
                 {"size", kNothing}}),
    };
}

std::vector<Table> lightTables() {
    return {
        lightTable("point", {{"position", "[0, 0, 0]"}}, {{"position", kNothing}, {"color", kNothing}}),
        lightTable("segment", {{"endpoints", "[[0, 0, 0], [1, 0, 0]]"}},
                   {{"endpoints", kNothing}, {"colors", kNothing}}),
        lightTable("parallelogram", {{"corner", "[0, 0, 0]"}, {"edges", "[[1, 0, 0], [0, 1, 0]]"}},
                   {{"corner", kNothing}, {"edges", kNothing}, {"colors", kNothing}}),
        section("[environment]", {}, {{"cube", kNothing}, {"equirect", kNothing}, {"generate", kNothing}}),
        inlined("[environment]\ncube = { ",
                {{"px", "\"a\""},
                 {"nx", "\"a\""},
                 {"py", "\"a\""},
                 {"ny", "\"a\""},
                 {"pz", "\"a\""},
                 {"nz", "\"a\""}},
                {{"px", kNothing},
                 {"nx", kNothing},
                 {"py", kNothing},
                 {"ny", kNothing},
                 {"pz", kNothing},
                 {"nz", kNothing}}),
    };
}

std::vector<Table> sceneTables() {
    std::vector<Table> all;
    for (const std::vector<Table>& some : {objectTables(), lightTables(), shapeTables()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

class TomlTypes : public SceneFiles {
  protected:
    /// The outcome of a table in which `key` has the value.
    std::string outcome(const Table& table, const std::string& key, const std::string& value) {
        std::string body = table.before + key + " = " + value;
        for (const auto& [other, text] : table.others)
            if (other != key) body += table.separator + other + " = " + text;
        text_ = "version = 1\n" + body + table.after + "\n";
        const std::string before = "version = 1\n" + table.before;
        line_ = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
        return errorOf(write("scene.toml", text_));
    }
    std::string text_;
    int line_ = 0;  ///< of the key
};

TEST_F(TomlTypes, EveryWrongTypeIsAnErrorAtItsLine) {
    for (const Table& table : sceneTables())
        for (const Key& key : table.keys)
            for (const std::string& value : kValues) {
                const std::string error = outcome(table, key.name, value);
                if (key.kind.accepted.contains(value)) {
                    EXPECT_THAT(error, ::testing::Not(HasSubstr(key.name + ": expected"))) << text_;
                    continue;
                }
                // A file that does not exist is named where the key is, too.
                EXPECT_THAT(error, StartsWith("scene.toml:")) << text_;
                int line = 0, column = 0;
                EXPECT_EQ(std::sscanf(error.c_str(), "scene.toml:%d:%d: error:", &line, &column), 2)
                    << error << '\n'
                    << text_;
                // What a whole table lacks is reported at its head.
                EXPECT_TRUE(line == line_ || line == line_ - 1) << error << '\n' << text_;
                EXPECT_GT(column, 0);
            }
}

/// The list above has all keys that the reader knows.
TEST_F(TomlTypes, EveryKeyIsTested) {
    for (const Table& table : sceneTables()) {
        const std::string error = outcome(table, "zzzzzzzz", "1");
        if (table.keys[0].name == "srgb") {  // a colour, which is a table with one key
            EXPECT_THAT(error, HasSubstr("{ srgb = [r, g, b] }"));
            continue;
        }
        ASSERT_THAT(error, HasSubstr("unknown key 'zzzzzzzz'")) << text_;
        std::string list = error.substr(error.find("expected ") + 9);
        for (std::size_t at = list.find(" or "); at != std::string::npos; at = list.find(" or "))
            list.replace(at, 4, ", ");
        std::set<std::string> known, tested;
        for (std::size_t start = 0; start < list.size();) {
            const std::size_t end = std::min(list.find(", ", start), list.size());
            known.insert(list.substr(start, end - start));
            start = end + 2;
        }
        for (const Key& key : table.keys) tested.insert(key.name);
        EXPECT_EQ(known, tested) << text_;
    }
}

TEST_F(TomlTypes, SettingsHaveTheTypeOfTheirTable) {
    for (const SettingInfo& info : describeSettings()) {
        const Table settings = section("[settings]", {}, {});
        const std::string key(info.key);
        for (const std::string& value : kValues) {
            const bool isNumber = value == "4" || value == "-4" || (info.kind == "number" && value == "4.5");
            if (info.kind == "boolean" && value == "true") continue;
            const std::string error = outcome(settings, key, value);
            if ((info.kind == "integer" || info.kind == "number") && isNumber) {
                const double number = std::stod(value);
                EXPECT_EQ(error.empty(), number >= info.lowest && number <= info.highest) << text_ << error;
                continue;
            }
            EXPECT_THAT(error, StartsWith("scene.toml:3:")) << text_;
        }
        EXPECT_EQ(outcome(settings, key,
                          info.kind == "choice" ? "\"" + info.defaultValue + "\"" : info.defaultValue),
                  "");
    }
    EXPECT_THAT(outcome(section("[settings]", {}, {}), "spp", "4.0"),
                HasSubstr("expected an integer, got a number"));
    EXPECT_THAT(outcome(section("[settings]", {}, {}), "spp", "\"4\""),
                HasSubstr("expected an integer, got a string"));
}

TEST_F(TomlTypes, TopLevelKeysHaveTheirTypes) {
    for (const std::string key :
         {"version", "title", "camera", "mesh", "sphere", "material", "light", "environment", "settings"})
        for (const std::string& value : kValues) {
            const std::string text = (key == "version" ? "" : "version = 1\n") + key + " = " + value + "\n";
            const std::string error = errorOf(write("scene.toml", text));
            const bool isTable = key == "material" || key == "settings",
                       isList = value == "[]" && key != "environment";
            if ((key == "title" && kText.accepted.contains(value)) || (isTable && value == "{}") ||
                (isList && !isTable && key != "title" && key != "version"))
                EXPECT_EQ(error, "") << text;
            else
                EXPECT_THAT(error, StartsWith(key == "version" ? "scene.toml:1:" : "scene.toml:2:")) << text;
        }
}

}  // namespace
}  // namespace rayscope::test
