// The shapes of the page's requests and answers. All answers in the other tests of the page are checked against them,
// too.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "labmouse/lab/page/calls.hpp"
#include "labmouse/lab/page/world_tables.hpp"
#include "labmouse/lab/races/world_entry.hpp"
#include "labmouse/lab/shapes/shapes.hpp"
#include "labmouse/lab/shapes/typescript.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/page/shape_check.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;

std::string core_file(const std::string& name) {
  std::ifstream file(std::string(LABMOUSE_SOURCE_DIR) + "/apps/web/page/src/core/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(PageShapes, AreWhatThePageReads) {
  EXPECT_TRUE(core_file("types.ts") == page_typescript()) << "types.ts is not up to date: run scripts/page-types";
}

TEST(PageShapes, AreThoseOfTheTablesOfWorlds) {
  const Json tables = world_tables_json();
  EXPECT_EQ(ReadJson::parse(core_file("worlds.json")), ReadJson::parse(tables.dump()))
      << "worlds.json is not up to date: run scripts/page-types";
  EXPECT_EQ(test::mismatch(ReadJson::parse(tables.dump()), shapes::named("ShownWorlds")), "");
}

/// A key that no mouse has would leave its column empty.
TEST(PageShapes, KnowTheFieldOfEachColumn) {
  for (const WorldEntry* entry : all_worlds()) {
    const auto world = entry->make({}).world;
    const auto has = [](const auto& fields, std::string_view key) {
      return std::any_of(fields.begin(), fields.end(), [&](const auto& field) { return field.key == key; });
    };
    EXPECT_TRUE(has(world->traits().fields->maze, world->traits().fields->bound)) << entry->name;
    for (const Column& column : world->traits().fields->columns)
      EXPECT_TRUE(column.key.empty() || has(world->traits().fields->mouse, column.key))
          << entry->name << " " << column.key;
  }
}

TEST(PageShapes, AreThereForEveryCallAndNoOther) {
  std::vector<std::string> names;
  for (const CallShape& call : call_shapes()) names.push_back(call.name);
  EXPECT_THAT(names, ::testing::UnorderedElementsAreArray(page_calls().begin(), page_calls().end()));
}

/// Names that no declaration has.
std::vector<std::string> strangers(const Shape& shape) {
  std::vector<std::string> names = shape.bases;
  if (shape.kind == Shape::Kind::named) names.push_back(shape.text);
  std::erase_if(names, [](const std::string& name) { return find_shape(name) != nullptr; });
  std::vector<Shape> inner = shape.parts;
  for (const ShapeField& field : shape.fields) inner.push_back(field.shape);
  for (const Shape& each : inner)
    for (const std::string& name : strangers(each)) names.push_back(name);
  return names;
}

TEST(PageShapes, NameOnlyShapesThatThereAre) {
  for (const Declaration& declaration : all_shapes())
    EXPECT_THAT(strangers(declaration.shape), ::testing::IsEmpty()) << declaration.name;
  for (const CallShape& call : call_shapes()) {
    EXPECT_THAT(strangers(call.request), ::testing::IsEmpty()) << call.name;
    EXPECT_THAT(strangers(call.answer), ::testing::IsEmpty()) << call.name;
  }
  EXPECT_THAT(strangers(shapes::list(shapes::named("Nobody"))), ::testing::ElementsAre("Nobody"));
}

std::string wrong(const char* json, const Shape& shape) { return test::mismatch(ReadJson::parse(json), shape); }

TEST(PageShapes, FindWhatIsMissingWhatIsOfAnotherKindAndWhatIsTooMuch) {
  using namespace shapes;
  const Shape mouse =
      object({field("name", text), maybe("age", or_null(number)), field("ways", list(words({"l", "r"})))});
  for (const char* good : {R"({"name":"a","ways":[]})", R"({"name":"a","age":null,"ways":["l","r"]})"})
    EXPECT_EQ(wrong(good, mouse), "") << good;
  EXPECT_THAT(wrong(R"({"ways":[]})", mouse), Says("it.name", "missing"));
  EXPECT_THAT(wrong(R"({"name":"a","age":"3","ways":[]})", mouse), Says("it.age", "number"));
  EXPECT_THAT(wrong(R"({"name":"a","ways":["l","x"]})", mouse), Says("it.ways[1]"));
  EXPECT_THAT(wrong(R"({"name":"a","ways":[],"more":1})", mouse), Says("it.more"));
  EXPECT_THAT(wrong(R"([1])", tuple({number, number})), Says("list of 2"));
  EXPECT_THAT(wrong(R"({"a":{"b":true}})", map(map(number))), Says("it.a.b", "number"));
  EXPECT_THAT(wrong("2", exactly(1)), Says("1"));
  const Shape kinds = either({object({field("a", object({field("b", number)}))}), object({field("c", flag)})});
  EXPECT_THAT(wrong(R"({"a":{"b":"x"}})", kinds), Says("it.a.b", "number"));
  EXPECT_THAT(wrong(R"({"walls":[]})", named("MazeData")), Says("missing"));
}

TEST(PageShapes, TakeFieldsOfTheirBases) {
  using namespace shapes;
  const Shape rules = object({field("name", text)}, {"Rules"});
  EXPECT_THAT(wrong(R"({"name":"a"})", rules), Says("it.budget", "missing"));
  EXPECT_EQ(wrong(R"({"name":"a","any":[1]})", object({field("name", text)}, {"Fields"})), "");
}

}  // namespace
}  // namespace labmouse
