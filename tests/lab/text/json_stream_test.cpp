#include "labmouse/lab/text/json_stream.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace labmouse {
namespace {

TEST(JsonStream, WritesWhatTheLibraryWrites) {
  const Json nested = {{"empty", Json::object()}, {"list", {1, "two\n\"lines\"", nullptr, Json::array({2.5})}}};
  const Json whole = {{"a", 1},
                      {"none", Json::array()},
                      {"objects", Json::array({nested, Json::object()})},
                      {"within", {{"b", nested}, {"c", "not \xff UTF-8"}}}};
  std::string text;
  JsonStream out([&text](std::string_view part) { text += part; });
  out.begin_object();
  out.fields({{"a", 1}});
  out.begin_list("none");
  out.end();
  out.begin_list("objects");
  out.value(nested);
  out.begin_object();
  out.end();
  out.end();
  out.begin_object("within");
  out.value(nested, "b");
  out.value("not \xff UTF-8", "c");
  out.end();
  out.end();
  out.finish();
  EXPECT_EQ(text, whole.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

TEST(JsonStream, HandsOverPartByPart) {
  std::size_t largest = 0, all = 0;
  JsonStream out([&](std::string_view part) {
    largest = std::max(largest, part.size());
    all += part.size();
  });
  out.begin_list();
  for (int i = 0; i < 100'000; ++i) out.value({{"number", i}});
  out.end();
  out.finish();
  EXPECT_GT(all, std::size_t{2'000'000});
  EXPECT_LT(largest, std::size_t{100'000});
}

}  // namespace
}  // namespace labmouse
