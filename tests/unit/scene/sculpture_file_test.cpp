#include "scene/sculpture_file.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "base/rng.h"
#include "base/stopwatch.h"
#include "support/instances.h"
#include "unit/scene/support.h"

namespace collage {
namespace {

using testing::error_of;
using testing::TemporaryFolder;

Instance random_instance(Rng& rng) {
  const auto number = [&] { return 2.0 * rng.uniform() - 1.0; };
  Instance instance;
  instance.element = static_cast<std::uint32_t>(rng.below(2));
  instance.scale = 0.1 + rng.uniform();
  instance.rotation = glm::normalize(glm::dquat(number(), number(), number(), number()));
  instance.translation = {number() * 1e-9, number() * 1e9, number()};
  return instance;
}

Sculpture some_sculpture(std::size_t instances) {
  const std::string hash(64, 'a');
  Sculpture sculpture{"0.1.0", "collage make \"a b\"", {}, {"meshes/target/body.obj", hash}, {},
                      {}};
  sculpture.options.elements.resize(2);
  sculpture.options.target.mesh = "/somewhere/body.obj";
  sculpture.options.render.look = "/somewhere/mine.inc";
  sculpture.options.packing.seed = 5;
  sculpture.elements = {{{"meshes/element-0/cup.obj", hash}, "cup", 1.25},
                        {{"meshes/element-1/hat.obj", hash}, "hat", 0.1}};
  Rng rng(1, 2);
  for (std::size_t i = 0; i < instances; ++i) {
    sculpture.instances.push_back(random_instance(rng));
  }
  return sculpture;
}

class SculptureFile : public ::testing::Test {
 protected:
  std::string written(const Sculpture& sculpture) const {
    write_sculpture(path, sculpture);
    return read_file(path);
  }

  /// The error of reading a sculpture of 3 instances with `from` replaced by `to`.
  std::string error(const std::string& from, const std::string& to) const {
    Sculpture sculpture = some_sculpture(3);
    sculpture.instances[1] = {1, 0.5, {1, 0, 0, 0}, {1, 2, 3}};
    std::string text = written(sculpture);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    write_file(path, text);
    const std::string message = error_of([&] { read_sculpture(path); });
    const std::size_t start = path.string().size() + 2;
    return message.substr(std::min(start, message.size()));
  }

  TemporaryFolder folder;
  std::filesystem::path path = folder.path() / "sculpture.json";
};

constexpr const char* remedy = "; make the folder again with collage make";

TEST_F(SculptureFile, ReadsBackTheSameBits) {
  const Sculpture sculpture = some_sculpture(200);
  written(sculpture);
  const Sculpture copy = read_sculpture(path);
  EXPECT_EQ(copy.version, sculpture.version);
  EXPECT_EQ(copy.command, sculpture.command);
  EXPECT_EQ(copy.target.path, sculpture.target.path);
  EXPECT_EQ(copy.elements[1].name, "hat");
  EXPECT_EQ(copy.elements[1].size, 0.1);
  EXPECT_EQ(copy.options.packing.seed, 5U);
  test::expect_same_instances(copy.instances, sculpture.instances);
}

TEST_F(SculptureFile, KeepsCredits) {
  Sculpture sculpture = some_sculpture(1);
  sculpture.elements[1].credit = Credit{"Hat \"H\"", "A. B.", "CC BY 3.0", "https://x.example"};
  written(sculpture);
  const Sculpture copy = read_sculpture(path);
  EXPECT_FALSE(copy.target.credit);
  EXPECT_FALSE(copy.elements[0].credit);
  ASSERT_TRUE(copy.elements[1].credit);
  EXPECT_EQ(copy.elements[1].credit->title, "Hat \"H\"");
  EXPECT_EQ(copy.elements[1].credit->link, "https://x.example");
}

TEST_F(SculptureFile, NamesOnlyWhatIsInTheFolder) {
  EXPECT_THAT(written(some_sculpture(1)), ::testing::Not(::testing::HasSubstr("somewhere")));
  const Sculpture copy = read_sculpture(path);
  EXPECT_EQ(copy.options.target.mesh, "meshes/target/body.obj");
  EXPECT_EQ(copy.options.elements[1].mesh, "meshes/element-1/hat.obj");
  EXPECT_EQ(copy.options.render.look, "mine.inc");
  EXPECT_EQ(copy.options.name, folder.path().filename());
}

TEST_F(SculptureFile, KeepsProps) {
  Sculpture sculpture = some_sculpture(1);
  sculpture.options.render.props = {"/somewhere/bowl.obj"};
  sculpture.props = {{"meshes/prop-0/bowl.obj", sculpture.target.sha256}};
  EXPECT_THAT(written(sculpture), ::testing::Not(::testing::HasSubstr("somewhere")));
  const Sculpture copy = read_sculpture(path);
  ASSERT_EQ(copy.props.size(), 1U);
  EXPECT_EQ(copy.props[0].path, "meshes/prop-0/bowl.obj");
  EXPECT_EQ(copy.options.render.props, std::vector<std::string>{"meshes/prop-0/bowl.obj"});
  write_file(path,
             written(sculpture).replace(read_file(path).find("\"props\": [\n"), 9, "\"credits\":"));
  EXPECT_THAT(error_of([&] { read_sculpture(path); }),
              ::testing::HasSubstr("props are not as many as options.render.props"));
}

TEST_F(SculptureFile, LettersStayLettersAndTheirMeshesAreTheInputs) {
  Sculpture sculpture = some_sculpture(1);
  sculpture.options.target.mesh.clear();
  sculpture.options.target.text = {"C", "DejaVu Sans:bold", 0.5, 0.0};
  sculpture.options.elements[1].text = {"ß", "/somewhere/own.ttf", 0.25, 0.03};
  EXPECT_THAT(written(sculpture), ::testing::Not(::testing::HasSubstr("somewhere")));
  const Sculpture copy = read_sculpture(path);
  EXPECT_TRUE(copy.options.target.mesh.empty());
  EXPECT_EQ(copy.options.target.text.string, "C");
  EXPECT_EQ(copy.target.path, "meshes/target/body.obj");
  EXPECT_EQ(copy.options.elements[0].mesh, "meshes/element-0/cup.obj");
  EXPECT_TRUE(copy.options.elements[1].mesh.empty());
  EXPECT_EQ(copy.options.elements[1].text.string, "ß");
  EXPECT_EQ(copy.options.elements[1].text.font, "own.ttf");
  EXPECT_EQ(copy.options.elements[1].text.bevel, 0.03);
}

TEST_F(SculptureFile, HasOneInstanceALine) {
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  const std::string text = written(some_sculpture(50));
  EXPECT_EQ(lines(text), lines(written(some_sculpture(0))) + 50);
  EXPECT_THAT(text, ::testing::HasSubstr("\"instances\": [\n{\"element\":"));
  EXPECT_THAT(text, ::testing::EndsWith("]}\n  ]\n}\n"));
  EXPECT_EQ(written(some_sculpture(0)).find("\"instances\": [\n  ]\n}\n") != std::string::npos,
            true);
  EXPECT_TRUE(read_sculpture(path).instances.empty());
}

TEST_F(SculptureFile, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(error("\"element\":1,\"scale\":0.5", "\"element\":2,\"scale\":0.5"),
            std::string("instances[1].element is not the index of an element") + remedy);
  EXPECT_EQ(error("\"scale\":0.5", "\"scale\":0"),
            std::string("instances[1].scale is not greater than 0") + remedy);
  EXPECT_EQ(error("\"scale\":0.5", "\"scale\":null"),
            std::string("instances[1].scale is not a finite number") + remedy);
  EXPECT_EQ(error("\"scale\":0.5,", ""), std::string("instances[1].scale is missing") + remedy);
  EXPECT_EQ(error("[1,0,0,0]", "[1,0.01,0,0]"),
            std::string("instances[1].rotation is not a unit quaternion") + remedy);
  EXPECT_EQ(error("[1,0,0,0]", "[1,0,0]"),
            std::string("instances[1].rotation is not a list of 4 numbers") + remedy);
  EXPECT_EQ(error("[1,2,3]", "[1,2,\"3\"]"),
            std::string("instances[1].translation[2] is not a finite number") + remedy);
  EXPECT_EQ(error("\"seed\": 5", "\"seed\": 6"),
            std::string("seed differs from options.packing.seed") + remedy);
  EXPECT_EQ(error("\"sha256\": \"a", "\"sha256\": \"A"),
            std::string("target.sha256 is not a SHA-256 of 64 hexadecimal digits") + remedy);
  EXPECT_EQ(error("\"path\": \"meshes/target/body.obj\"", "\"path\": \"a/../../b.obj\""),
            std::string("target.path is not a path inside the folder") + remedy);
  EXPECT_EQ(error("\"path\": \"meshes/element-0/cup.obj\"", "\"path\": \"/etc/passwd\""),
            std::string("elements[0].path is not a path inside the folder") + remedy);
  EXPECT_EQ(error("{\"name\": \"cup\"", "1, {\"name\": \"cup\""),
            std::string("elements[0].path is missing") + remedy);
  EXPECT_THAT(error("\"jitter\": 0.5", "\"jitter\": 5"),
              ::testing::StartsWith("options.target.jitter is not accepted: target.jitter = 5 is "
                                    "out of range"));
  EXPECT_EQ(error("\"text.string\": \"\"", "\"text.string\": \"C\""),
            std::string("options.target does not name exactly one of mesh, sdf and text") + remedy);
  EXPECT_EQ(error("\"mesh\": \"meshes/element-1/hat.obj\"", "\"mesh\": \"\""),
            std::string("options.element[1] does not name exactly one of mesh and text") + remedy);
  EXPECT_THAT(error("\"seed\": 5", "\"seed\": nan"), ::testing::StartsWith("is not JSON: "));
}

/// The slow twin: a space sends the whole file to the reader of JSON.
TEST_F(SculptureFile, ReadsTheSameOfOtherSpacing) {
  const std::string text = written(some_sculpture(500));
  const std::vector<Instance> fast = read_sculpture(path).instances;
  std::string spaced = text;
  spaced.replace(spaced.rfind("\"scale\":"), 8, "\"scale\": ");
  folder.write("sculpture.json", spaced);
  const std::vector<Instance> slow = read_sculpture(path).instances;
  ASSERT_EQ(fast.size(), slow.size());
  for (std::size_t i = 0; i < fast.size(); ++i) {
    EXPECT_EQ(fast[i].element, slow[i].element);
    EXPECT_EQ(fast[i].scale, slow[i].scale);
    EXPECT_EQ(fast[i].rotation, slow[i].rotation);
    EXPECT_EQ(fast[i].translation, slow[i].translation);
  }
}

TEST_F(SculptureFile, HandlesALargeSculpture) {
  const Sculpture sculpture = some_sculpture(300000);
  const Stopwatch writing;
  written(sculpture);
  EXPECT_LT(writing.seconds(), 10.0);
  EXPECT_EQ(read_sculpture(path).instances.size(), 300000U);
}

}  // namespace
}  // namespace collage
