// The tables of settings and of stored figures of all worlds.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/failure_rates/physical_settings.hpp"
#include "labmouse/lab/mms/mms_world.hpp"
#include "labmouse/lab/steps/steps_world.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse {
namespace {

template <class Rows>
void expect_usual_defaults(const Rows& rows) {
  typename Rows::value_type::Of chosen, usual;
  EXPECT_EQ(choose(rows, {}, chosen), "");
  for (const auto& row : rows) EXPECT_EQ(row.of(chosen), row.of(usual)) << row.setting.name;
}

TEST(Settings, HaveTheDefaultsOfTheirConditions) {
  expect_usual_defaults(steps_rows);
  expect_usual_defaults(mms_rows);
  expect_usual_defaults(physical_rows);
}

TEST(Settings, NameTheLevelsOfTheVariation) {
  for (const NamedNumber& level : variation_levels) {
    PhysicalConditions conditions;
    EXPECT_EQ(choose(physical_rows, {{"variation", std::string(level.name)}}, conditions), "");
    EXPECT_EQ(conditions.errors.variation, level.number);
    EXPECT_THAT(std::string(variation_row.setting.meaning),
                ::testing::HasSubstr(fmt::format("{} ({:g})", level.name, level.number)));
  }
}

TEST(Settings, SayWhatCanBeChosen) {
  const auto problem = [](const std::string& name, const std::string& text) {
    PhysicalConditions conditions;
    return choose(physical_rows, {{name, text}}, conditions);
  };
  EXPECT_EQ(problem("pace", "0.2"), "");
  EXPECT_EQ(problem("pace", "0.1"), "error: --pace: '0.1' is not a number from 0.2 to 1");
  EXPECT_EQ(problem("noise", "100.5"), "error: --noise: '100.5' is not a number from 0 to 100");
  EXPECT_EQ(problem("variation", "ten"),
            "error: --variation: 'ten' is not a number from 0 to 10, or one of lab, practice, contest, bad-day");
  EXPECT_EQ(problem("search-speed", "0"), "");
  EXPECT_EQ(problem("search-speed", "5"),
            "error: --search-speed: '5' is neither 0 nor a number from 10 to 20000 mm/s; if the value is in m/s, write "
            "5000");
  for (const char* unlikely : {"30000", "0.001", "fast"})
    EXPECT_TRUE(problem("search-speed", unlikely).ends_with("20000 mm/s")) << unlikely;
  EXPECT_EQ(problem("map", "last"), "error: --map: 'last' is none of first, log-odds and log-odds-prior");
  Rules rules;
  EXPECT_EQ(choose(steps_rows, {{"budget", "1.5"}}, rules),
            "error: --budget: '1.5' is not a whole number from 1 to 1000000");
}

TEST(Settings, AreReadUnderFormerNames) {
  PhysicalConditions chosen, read;
  EXPECT_EQ(choose(physical_rows, {{"map", "belief"}}, chosen), "");
  EXPECT_EQ(chosen.map, MapKind::log_odds);
  const ReadJson old = read_json(R"({"noise":2,"spread":3,"search_speed":4,"map":"learned"})");
  JsonFields fields(old, "");
  read_settings(physical_rows, fields, read);
  EXPECT_EQ(fields.error(), "");
  EXPECT_EQ(read.errors.noise, 2.0);
  EXPECT_EQ(read.errors.variation, 3.0);
  EXPECT_EQ(read.controller.search_speed, 4.0);
  EXPECT_EQ(read.controller.pace, 1.0);
  EXPECT_EQ(read.map, MapKind::learned);
}

/// The fields of the figures in stores of all versions, in their order; "-" is a figure without one.
constexpr const char* stored_in_steps =
    "search_steps speed_steps discovered_share visited_share blocked_steps void_rotations cut_movements idle_resets - "
    "last_words counts - -";
constexpr const char* stored_in_seconds =
    "score search_us best_us excess proven starts decisions replanned discovered_share visited_share last_words "
    "score_us gate_to_gate_us rest_to_centre_us";
constexpr const char* stored_with_errors =
    "score search_us best_us excess starts done slid position_lost wall_error no_route_left late carried grazes "
    "wrong_walls contradictions severity par1 decisions replanned discovered_share visited_share ended_by last_words "
    "score_us gate_to_gate_us rest_to_centre_us";
constexpr const char* stored_in_mms =
    "outcome end finished score best_run run_ratio statistics - lines invalid_lines log errors simulated_seconds "
    "seconds visited_share";

const ContestField& field_called(const WorldFields& fields, std::string_view key) {
  for (const auto& list : {fields.contest, fields.csv})
    for (const ContestField& field : list)
      if (field.key == key) return field;
  throw std::out_of_range(std::string(key));
}

TEST(StoredFigures, HaveThePlacesThatTheyHaveInEarlierStores) {
  const std::map<std::string_view, std::string> stored = {{"steps", stored_in_steps},
                                                          {"seconds", stored_in_seconds},
                                                          {"physical", stored_with_errors},
                                                          {"failures", stored_with_errors},
                                                          {"mms", stored_in_mms}};
  for (const WorldEntry* entry : all_worlds()) {
    const WorldFields& fields = *entry->make({}).world->traits().fields;
    const std::vector<Value> usual = fields.figures.values_of(*fields.figures.make());
    std::istringstream keys(stored.at(entry->name));
    std::string key;
    for (std::size_t place = 0; place < usual.size(); ++place) {
      ASSERT_TRUE(keys >> key) << entry->name;
      int kinds = 0;
      for (const Value& other : {Value(true), Value(std::int64_t{7}), Value(7.5), Value("7"), Value(JsonText{"[7]"})}) {
        std::vector<Value> values = usual;
        values[place] = other;
        ContestResult result;
        result.figures = fields.figures.figures_of(values);
        if (!result.figures) continue;
        ++kinds;
        const Value shown = key == "-" ? other : field_called(fields, key).of({}, result);
        EXPECT_EQ(shown, other) << entry->name << ' ' << key;
      }
      EXPECT_EQ(kinds, 1) << entry->name << ' ' << key;
    }
    EXPECT_FALSE(keys >> key) << entry->name << ' ' << key;
  }
}

}  // namespace
}  // namespace labmouse
