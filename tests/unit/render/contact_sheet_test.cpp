#include "render/contact_sheet.h"

#include "unit/render/support.h"

namespace collage {
namespace {

using testing::error_of;
using ::testing::HasSubstr;
using testing::plain_picture;
using testing::TestFolder;

class ContactSheet : public ::testing::Test {
 protected:
  std::filesystem::path picture(const std::string& name, const Picture& content) {
    write_picture(folder_ / name, content);
    return folder_ / name;
  }
  Picture sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout) {
    write_contact_sheet(pictures, layout, folder_ / "sheet.png");
    return read_picture(folder_ / "sheet.png");
  }
  static float value(const Picture& picture, int x, int y) {
    return picture.values.at(static_cast<std::size_t>(y * picture.width + x) * 3);
  }
  /// Pixels of just this red value.
  static long count(const Picture& picture, float red) {
    long pixels = 0;
    for (std::size_t i = 0; i < picture.values.size(); i += 3) {
      pixels += std::abs(picture.values[i] - red) < 1e-4 ? 1 : 0;
    }
    return pixels;
  }
  TestFolder folder_;
};

constexpr float grey = 102.0F / 255.0F;

TEST_F(ContactSheet, pictures_are_never_made_larger) {
  const auto path = picture("a.png", plain_picture(40, 30, grey));
  const Picture page = sheet({{path, ""}, {path, ""}, {path, ""}}, {.columns = 2});
  EXPECT_EQ(count(page, grey), 3 * 40 * 30);
  EXPECT_EQ(value(page, 0, 0), 1.0F);
}

TEST_F(ContactSheet, mixed_sizes_keep_their_proportions_and_share_a_cell) {
  const auto wide = picture("wide.png", plain_picture(200, 100, grey));
  const auto tall = picture("tall.png", plain_picture(30, 90, grey));
  const Picture page = sheet({{wide, ""}, {tall, ""}}, {.columns = 2, .cell_size = 60});
  EXPECT_EQ(count(page, grey), 60 * 30 + 20 * 60);
}

TEST_F(ContactSheet, captions_may_have_several_lines) {
  const auto path = picture("a.png", plain_picture(100, 75, grey));
  const Picture one = sheet({{path, "first"}}, {});
  const Picture two = sheet({{path, "first\nsecond"}}, {});
  EXPECT_EQ(two.height, one.height + 14);
  EXPECT_EQ(count(two, grey), count(one, grey));
  const auto ink = [](const Picture& page, int from) {
    const auto first = page.values.begin() + std::ptrdiff_t{from} * page.width * 3;
    return std::count_if(first, page.values.end(), [](float value) { return value < 0.7F; });
  };
  EXPECT_GT(ink(two, one.height - 8), 0);
}

TEST_F(ContactSheet, fewer_pictures_than_columns_leave_no_gap) {
  const auto path = picture("a.png", plain_picture(40, 30, grey));
  EXPECT_EQ(sheet({{path, ""}}, {.columns = 9}).width, sheet({{path, ""}}, {.columns = 1}).width);
}

TEST_F(ContactSheet, pictures_shrink_in_linear_light) {
  Picture checks = plain_picture(128, 128, 0.0F);
  for (std::size_t i = 0; i < checks.values.size(); ++i) {
    const std::size_t pixel = i / 3;
    checks.values[i] = static_cast<float>((pixel + pixel / 128) % 2);
  }
  const Picture page =
      sheet({{picture("checks.png", checks), ""}}, {.columns = 1, .cell_size = 32});
  EXPECT_NEAR(value(page, page.width / 2, page.height / 2), 0.735, 0.02) << "half the light";
}

TEST_F(ContactSheet, captions_add_ink_below_and_stay_in_their_cell) {
  const auto path = picture("a.png", plain_picture(120, 90, grey));
  const std::string long_caption(300, 'W');
  const Picture bare = sheet({{path, ""}, {path, ""}}, {.columns = 2});
  const Picture page = sheet({{path, long_caption}, {path, ""}}, {.columns = 2});
  EXPECT_EQ(page.width, bare.width);
  EXPECT_GT(page.height, bare.height);
  EXPECT_LT(count(page, 1.0F) - count(bare, 1.0F), page.width * (page.height - bare.height));
  for (int y = 0; y < page.height; ++y) {
    EXPECT_EQ(value(page, page.width / 2, y), 1.0F) << "the gap between the cells is empty";
  }
}

TEST_F(ContactSheet, equal_input_gives_equal_bytes) {
  const auto path = picture("a.png", plain_picture(40, 30, grey));
  const std::vector<SheetPicture> pictures = {{path, "größe – 10 %"}};
  const SheetLayout layout{.page = Page::soft_grey, .title = "Title"};
  write_contact_sheet(pictures, layout, folder_ / "one.png");
  write_contact_sheet(pictures, layout, folder_ / "two.png");
  EXPECT_EQ(read_file(folder_ / "one.png"), read_file(folder_ / "two.png"));
}

TEST_F(ContactSheet, grey_transparent_and_float_pictures_will_do) {
  Picture linear = plain_picture(20, 20, 0.5F);
  linear.format = PictureFormat::exr;
  const Picture page = sheet({{picture("grey.png", plain_picture(20, 20, grey, 1)), ""},
                              {picture("clear.png", plain_picture(20, 20, grey, 4)), ""},
                              {picture("float.exr", linear), ""}},
                             {.columns = 3});
  EXPECT_GE(count(page, grey), 400);
  EXPECT_EQ(count(page, 188.0F / 255.0F), 400) << "0.5 of the light";
}

TEST_F(ContactSheet, says_what_is_wrong) {
  EXPECT_THAT(error_of([&] { sheet({}, {}); }), HasSubstr("of no pictures"));
  EXPECT_THAT(error_of([&] {
                sheet({{folder_ / "none.png", ""}}, {});
              }),
              HasSubstr("none.png: no such file"));
}

}  // namespace
}  // namespace collage
