#include "scene/options_json.h"

#include <nlohmann/json.hpp>

#include "scene/json_reader.h"
#include "scene/options_table.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

Scene some_scene() {
  Scene scene;
  scene.elements.resize(2);
  scene.target.mesh = "meshes/target/body.obj";
  scene.elements[0].mesh = "meshes/element-0/cup.obj";
  scene.elements[1].mesh = "meshes/element-1/hat.obj";
  scene.elements[1].color = "#102030";
  scene.packing.threshold = 0.0123;
  scene.packing.scaling = Scaling::to_hole;
  scene.contact_sheet.stages = {0.02, 1};
  scene.render.look = "mine.inc";
  return scene;
}

TEST(OptionsJson, HoldsAllKeysAndReadsBackTheSame) {
  const Scene scene = some_scene();
  const auto json = nlohmann::json::parse(options_json(scene));
  const Scene copy = options_from_json(json);
  ASSERT_EQ(copy.elements.size(), 2U);
  for (const Option& option : options_table()) {
    const auto& section = json.at(option.section());
    EXPECT_TRUE((option.of_element() ? section.at(0) : section).contains(option.name()));
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(option.load(copy, k), option.load(scene, k)) << option.key;
    }
  }
}

TEST(OptionsJson, TakesDefaultsForMissingKeysAndRefusesUnknownOnes) {
  auto json = nlohmann::json::parse(options_json(some_scene()));
  json["packing"].erase("threshold");
  EXPECT_EQ(options_from_json(json).packing.threshold, PackingOptions{}.threshold);
  const auto problem = [&] {
    try {
      options_from_json(json);
    } catch (const json_reader::Problem& caught) {
      return caught.where + " " + caught.what;
    }
    return std::string();
  };
  json["packing"]["thresh"] = 1;
  EXPECT_EQ(problem(), ".packing.thresh is not an option");
  json["packing"].erase("thresh");
  json["element"][1]["weight"] = -1;
  EXPECT_EQ(problem().substr(0, 60),
            ".element[1].weight is not accepted: element.1.weight = -1 is");
  json.erase("element");
  EXPECT_EQ(problem(), ".element is missing");
}

}  // namespace
}  // namespace collage
