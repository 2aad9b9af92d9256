#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace collage {

struct SheetPicture {
  std::filesystem::path path;
  /// UTF-8; a line that is wider than its cell is shortened with "…". "": none.
  std::string caption;
};

enum class Page { white, soft_grey };

/// Lengths in pixels.
struct SheetLayout {
  int columns = 4;
  /// Pictures larger than this on either side are made smaller; none is made larger.
  int cell_size = 400;
  Page page = Page::white;
  /// At the top; "": none.
  std::string title{};
};

/// Lays pictures (PNG or EXR, of any sizes) out in rows on one page and writes it as a PNG, whole
/// or not at all; equal input gives equal bytes. Every cell is as large as the largest picture,
/// others are centred in theirs. Made smaller in linear light. Throws Error where a picture cannot
/// be read, or the font DejaVu Sans is missing while there is something to write.
void write_contact_sheet(const std::vector<SheetPicture>& pictures, const SheetLayout& layout,
                         const std::filesystem::path& output);

}  // namespace collage
