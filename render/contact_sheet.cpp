#include "render/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "render/lettering.h"
#include "render/picture_file.h"
#include "render/thumbnail.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

constexpr float title_grey = 0.16F;
constexpr float caption_grey = 0.38F;

std::vector<std::string> lines_of(const std::string& caption) {
  std::vector<std::string> lines;
  std::istringstream text(caption);
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  return lines;
}

int rounded(double value) { return static_cast<int>(std::lround(value)); }

/// Where things stand on the page; all lengths in pixels, in proportion to the width of a cell.
class Grid {
 public:
  Grid(const std::vector<Picture>& pictures, const std::vector<SheetPicture>& captions,
       const SheetLayout& layout)
      : columns_(std::clamp(layout.columns, 1, static_cast<int>(pictures.size()))),
        rows_((static_cast<int>(pictures.size()) + columns_ - 1) / columns_) {
    for (const Picture& picture : pictures) {
      cell_width = std::max(cell_width, picture.width);
      cell_height = std::max(cell_height, picture.height);
    }
    std::size_t lines = 0;
    for (const SheetPicture& picture : captions) {
      lines = std::max(lines, lines_of(picture.caption).size());
    }
    has_captions = lines > 0;
    caption_size = std::clamp(rounded(cell_width * 0.042), 10, 28);
    title_size = rounded(caption_size * 1.75);
    gap_ = std::max(8, rounded(cell_width * 0.05));
    margin = std::max(20, rounded(cell_width * 0.13));
    line_height = rounded(caption_size * 1.4);
    caption_height_ =
        has_captions ? rounded(caption_size * 2.4) + line_height * (static_cast<int>(lines) - 1)
                     : 0;
    title_height_ = layout.title.empty() ? 0 : rounded(title_size * 1.1) + margin / 2;
  }

  [[nodiscard]] int width() const {
    return 2 * margin + columns_ * cell_width + (columns_ - 1) * gap_;
  }
  [[nodiscard]] int height() const {
    return 2 * margin + title_height_ + rows_ * (cell_height + caption_height_) +
           (rows_ - 1) * gap_ - (has_captions ? rounded(caption_size * 2.4) / 3 : 0);
  }
  [[nodiscard]] int left(std::size_t index) const {
    return margin + static_cast<int>(index) % columns_ * (cell_width + gap_);
  }
  [[nodiscard]] int top(std::size_t index) const {
    const int row = static_cast<int>(index) / columns_;
    return margin + title_height_ + row * (cell_height + caption_height_ + gap_);
  }

  bool has_captions = false;
  int cell_width = 1;
  int cell_height = 1;
  int caption_size = 0;
  int line_height = 0;
  int title_size = 0;
  int margin = 0;

 private:
  int columns_;
  int rows_;
  int gap_ = 0;
  int caption_height_ = 0;
  int title_height_ = 0;
};

Picture empty_page(const Grid& grid, Page page) {
  constexpr int largest_side = 32768;
  if (std::max(grid.width(), grid.height()) > largest_side) {
    throw Error("a contact sheet of " + std::to_string(grid.width()) + " x " +
                    std::to_string(grid.height()) + " pixels is too large",
                "choose another number of columns or smaller pictures");
  }
  Picture picture;
  picture.width = grid.width();
  picture.height = grid.height();
  picture.values.assign(picture.pixels() * 3, page == Page::white ? 1.0F : 0.93F);
  return picture;
}

/// Both with three channels, `picture` inside the page.
void paste(Picture& page, const Picture& picture, int left, int top) {
  const auto row_values = static_cast<std::ptrdiff_t>(picture.width) * 3;
  for (std::ptrdiff_t y = 0; y < picture.height; ++y) {
    std::copy_n(picture.values.begin() + y * row_values, row_values,
                page.values.begin() + ((top + y) * page.width + left) * 3);
  }
}

void write_captions(Picture& page, const Grid& grid, const std::vector<SheetPicture>& pictures) {
  const Lettering letters(grid.caption_size);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    int baseline = grid.top(i) + grid.cell_height + rounded(grid.caption_size * 1.7);
    for (const std::string& line : lines_of(pictures[i].caption)) {
      const std::string text = letters.fitted(line, grid.cell_width);
      const int left = grid.left(i) + (grid.cell_width - letters.width(text)) / 2;
      letters.write(page, left, baseline, text, caption_grey);
      baseline += grid.line_height;
    }
  }
}

void write_title(Picture& page, const Grid& grid, const std::string& title) {
  const Lettering letters(grid.title_size);
  letters.write(page, grid.margin, grid.margin + rounded(grid.title_size * 0.8),
                letters.fitted(title, grid.width() - 2 * grid.margin), title_grey);
}

}  // namespace

void write_contact_sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout,
                         const fs::path& output) {
  if (pictures.empty()) {
    throw Error({output}, "a contact sheet of no pictures cannot be made", "name some pictures");
  }
  std::vector<Picture> thumbnails;
  thumbnails.reserve(pictures.size());
  for (const SheetPicture& picture : pictures) {
    thumbnails.push_back(thumbnail(picture.path, std::max(1, layout.cell_size)));
  }
  const Grid grid(thumbnails, pictures, layout);
  Picture page = empty_page(grid, layout.page);
  for (std::size_t i = 0; i < thumbnails.size(); ++i) {
    paste(page, thumbnails[i], grid.left(i) + (grid.cell_width - thumbnails[i].width) / 2,
          grid.top(i) + (grid.cell_height - thumbnails[i].height) / 2);
  }
  if (grid.has_captions) {
    write_captions(page, grid, pictures);
  }
  if (!layout.title.empty()) {
    write_title(page, grid, layout.title);
  }
  write_picture(output, page);
}

}  // namespace collage
