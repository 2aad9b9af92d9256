#include "geometry/letters.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/error.h"
#include "geometry/font_outline.h"
#include "geometry/mesh_check.h"
#include "geometry/topology.h"
#include "geometry/triangle_intersection.h"
#include "unit/geometry/test_letters.h"

namespace collage {
namespace {

class Notes : public Status {
 public:
  void note(std::string_view line) override { lines.emplace_back(line); }
  std::vector<std::string> lines;
};

Mesh letters(const std::string& string, double bevel = 0.0,
             const std::string& font = "DejaVu Sans:bold") {
  Status silent;
  return make_letters({string, font, 0.4, bevel}, silent);
}

/// Vertices - edges + triangles: twice the parts, less twice the holes through them.
int euler_characteristic(const Mesh& mesh) {
  const Topology topology(mesh);
  return static_cast<int>(check_mesh(mesh).vertices) - static_cast<int>(topology.edge_count()) +
         static_cast<int>(mesh.triangles.size());
}

bool have_a_corner_in_common(const uvec3& a, const uvec3& b) {
  for (int k = 0; k < 3; ++k) {
    if (a[k] == b.x || a[k] == b.y || a[k] == b.z) {
      return true;
    }
  }
  return false;
}

/// Whether two triangles that have no corner in common have a point in common.
bool intersects_itself(const Mesh& mesh) {
  std::vector<Box> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      boxes[t].include(mesh.corner(t, k));
    }
  }
  for (std::size_t s = 0; s < boxes.size(); ++s) {
    for (std::size_t t = 0; t < s; ++t) {
      const bool near = glm::all(glm::lessThanEqual(boxes[s].min, boxes[t].max)) &&
                        glm::all(glm::lessThanEqual(boxes[t].min, boxes[s].max));
      if (near && !have_a_corner_in_common(mesh.triangles[s], mesh.triangles[t]) &&
          triangles_intersect({mesh.corner(s, 0), mesh.corner(s, 1), mesh.corner(s, 2)},
                              {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)})) {
        return true;
      }
    }
  }
  return false;
}

void expect_sound(const Mesh& mesh, const std::string& what) {
  const MeshReport report = check_mesh(mesh);
  EXPECT_TRUE(report.closed) << what;
  EXPECT_EQ(report.nonmanifold_edges + report.inconsistent_edges + report.degenerate_triangles, 0U)
      << what;
  Mesh copy = mesh;
  EXPECT_EQ(text_of(orient(copy)), "") << what;
}

TEST(Letters, ManyCharactersOfManyFontsAreSoundSolids) {
  for (const char* font : {"DejaVu Sans", "DejaVu Sans:bold", "DejaVu Serif", "DejaVu Serif:bold",
                           "DejaVu Sans Mono"}) {
    for (const std::string& character : some_characters()) {
      const std::string what = character + " of " + font;
      const Mesh flat = letters(character, 0.0, font);
      expect_sound(flat, what);
      const double area = inked_area(read_outlines(find_font(font), character, 0.001), 2000);
      EXPECT_NEAR(enclosed_volume(flat), 0.4 * area, 0.0006) << what;
      const Mesh bevelled = letters(character, 0.03, font);
      expect_sound(bevelled, what + " with a bevel");
      EXPECT_EQ(euler_characteristic(bevelled), euler_characteristic(flat)) << what;
      const bool hangs_by_a_thread = character == "▚";
      EXPECT_LT(enclosed_volume(bevelled), enclosed_volume(flat) + (hangs_by_a_thread ? 1e-9 : 0))
          << what;
    }
  }
}

TEST(Letters, HaveTheHolesAndPartsOfTheLetter) {
  struct Case {
    const char* string;
    std::size_t parts;
    int holes;
  };
  for (const Case& c :
       {Case{"C", 1, 0}, Case{"O", 1, 1}, Case{"B", 1, 2}, Case{"8", 1, 2}, Case{"i", 2, 0},
        Case{"ö", 3, 1}, Case{"%", 3, 2}, Case{"Å", 1, 2}, Case{"AB", 2, 3}, Case{"…", 3, 0}}) {
    for (const double bevel : {0.0, 0.03}) {
      const Mesh mesh = letters(c.string, bevel);
      EXPECT_EQ(check_mesh(mesh).parts, c.parts) << c.string;
      EXPECT_EQ(euler_characteristic(mesh), 2 * static_cast<int>(c.parts) - 2 * c.holes)
          << c.string;
    }
  }
}

TEST(Letters, AreAsBigAsTheySay) {
  const Box box = bounding_box(letters("H"));
  EXPECT_EQ(box.min.y, 0.0);
  EXPECT_EQ(box.max.y, 1.0);
  EXPECT_EQ(box.min.z, -0.2);
  EXPECT_EQ(box.max.z, 0.2);
  EXPECT_GT(box.min.x, 0.0);
}

TEST(Letters, BevelIsAsWideAsItSaysAndCrossesNothing) {
  for (const char* character : {"B", "g", "&", "@", "W", "Ø"}) {
    const Mesh mesh = letters(character, 0.03, "DejaVu Serif:bold");
    EXPECT_FALSE(intersects_itself(mesh)) << character;
    EXPECT_EQ(bounding_box(mesh).max.z, 0.2);
  }
  const Mesh bar = letters("I", 0.05);
  const Mesh flat = letters("I");
  const dvec3 size = bounding_box(flat).extent();
  // A box less two frusta's surroundings.
  const double face = (size.x - 0.1) * (size.y - 0.1);
  const double rim = size.x * size.y;
  const double middle = (size.x - 0.05) * (size.y - 0.05);
  const double frustum = 0.05 / 6.0 * (face + 4.0 * middle + rim);
  EXPECT_NEAR(enclosed_volume(bar), rim * 0.3 + 2.0 * frustum, 1e-5);
}

TEST(Letters, ThinStrokesTakeASmallerBevelAndSaySo) {
  Notes notes;
  const Mesh mesh = make_letters({"H", "DejaVu Sans", 0.4, 0.15}, notes);
  expect_sound(mesh, "H");
  EXPECT_FALSE(intersects_itself(mesh));
  ASSERT_EQ(notes.lines.size(), 1U);
  EXPECT_THAT(notes.lines[0], ::testing::MatchesRegex("\"H\" is too thin for a bevel of 0.15; "
                                                      "where it is thinnest it has 0.0[0-9]*"));
  const Mesh shallow = make_letters({"H", "DejaVu Sans:bold", 0.05, 0.05}, notes);
  expect_sound(shallow, "H");
  EXPECT_EQ(notes.lines.size(), 2U);
}

TEST(Letters, WordsAreInOneMesh) {
  const Mesh word = letters("AVATAR");
  EXPECT_EQ(check_mesh(word).parts, 6U);
  expect_sound(word, "AVATAR");
}

TEST(Letters, BlankTextIsRefused) {
  const auto error = [](const std::string& text) -> std::string {
    try {
      letters(text);
    } catch (const Error& caught) {
      return caught.what();
    }
    return "";
  };
  EXPECT_EQ(error(" "), "the text for letters, \" \", is blank; write a letter in it");
  EXPECT_EQ(error(""), "the text for letters, \"\", is blank; write a letter in it");
}

}  // namespace
}  // namespace collage
