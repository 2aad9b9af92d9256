#include "scene/options_table.h"

#include <set>

#include "scene/option_check.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

Scene scene_with_element() {
  Scene scene;
  scene.elements.resize(1);
  return scene;
}

bool is_unset(const OptionValue& value) { return value == OptionValue(std::string()); }

TEST(OptionsTable, HasEachKeyOnceUnderItsSection) {
  std::set<std::string> keys;
  for (const Option& option : options_table()) {
    EXPECT_TRUE(keys.insert(option.key).second) << option.key;
    EXPECT_EQ(find_option(option.key), &option);
    EXPECT_FALSE(option.help.empty()) << option.key;
  }
  EXPECT_EQ(option_sections(), (std::vector<std::string>{"target", "element", "packing", "render",
                                                         "turntable", "contact_sheet"}));
  EXPECT_EQ(find_option("packing"), nullptr);
}

TEST(OptionsTable, AcceptsItsOwnDefaults) {
  const Scene scene = scene_with_element();
  for (const Option& option : options_table()) {
    const OptionValue value = option.load(scene, 0);
    if (!is_unset(value)) {
      EXPECT_EQ(testing::error_of([&] { checked(option, 0, value, {}); }), "");
    }
  }
}

TEST(OptionsTable, StoresWhatItLoads) {
  Scene scene = scene_with_element();
  scene.packing.scaling = Scaling::to_hole;
  scene.packing.choose = Choose::weighted;
  scene.packing.distance = Distance::vertices;
  scene.packing.seed = 12;
  scene.render.size = {17, 18};
  scene.elements[0].color = "#123456";
  Scene copy = scene_with_element();
  for (const Option& option : options_table()) {
    option.store(copy, 0, option.load(scene, 0));
  }
  for (const Option& option : options_table()) {
    EXPECT_EQ(option.load(copy, 0), option.load(scene, 0)) << option.key;
  }
}

TEST(OptionsTable, HasAWordForEachEnumerator) {
  Scene scene = scene_with_element();
  for (const char* key : {"packing.scaling", "packing.choose", "packing.fit", "packing.distance"}) {
    const Option& option = *find_option(key);
    for (const std::string& word : option.words) {
      option.store(scene, 0, word);
      EXPECT_EQ(option.load(scene, 0), OptionValue(word));
    }
  }
}

}  // namespace
}  // namespace collage
