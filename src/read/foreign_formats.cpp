#include "read/foreign_formats.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "read/text/lines.hpp"
#include "read/text/tokens.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace winnow {

namespace {

using namespace std::string_view_literals;

enum class Way : std::uint8_t { through, extracted, exported, reconstructed, none };

struct ForeignFormat {
  std::size_t at;  // where the magic stands; `text_begin`: behind blanks, in any case of letters
  std::string_view magic;   // in small letters for a text
  std::string_view inside;  // also stands somewhere in the first bytes
  const char* what;
  Way way;
  const char* more = "";  // through which command it becomes a mesh; else, what there is to add
};

constexpr std::size_t text_begin = SIZE_MAX;

// The more special ones first.
constexpr std::array foreign_formats{
    ForeignFormat{0, "PK\3\4"sv, "3D/3dmodel.model", "a 3MF model", Way::exported},
    ForeignFormat{0, "PK\3\4"sv, "", "a ZIP archive", Way::through, "unzip -p FILE"},
    ForeignFormat{0, "PK\5\6"sv, "", "an empty ZIP archive", Way::none},
    ForeignFormat{0, "7z\xbc\xaf\x27\x1c"sv, "", "a 7z archive", Way::through, "7z x -so FILE"},
    ForeignFormat{0, "Rar!\x1a\x07"sv, "", "a RAR archive", Way::through, "unrar p -inul FILE"},
    ForeignFormat{257, "ustar"sv, "", "a tar archive", Way::through, "tar -xOf FILE MEMBER"},
    ForeignFormat{0, "\xfd\x37zXZ\0"sv, "", "compressed by xz", Way::through, "xzcat FILE"},
    ForeignFormat{0, "BZh"sv, "1AY&SY", "compressed by bzip2", Way::through, "bzcat FILE"},
    ForeignFormat{0, "\x04\x22\x4d\x18"sv, "", "compressed by lz4", Way::through, "lz4cat FILE"},
    ForeignFormat{0, "LZIP"sv, "", "compressed by lzip", Way::through, "lzip -dc FILE"},
    ForeignFormat{0, "\x5d\0\0"sv, "", "compressed by lzma", Way::through, "xzcat FILE"},
    // Once is seen through before.
    ForeignFormat{0, "\x1f\x8b\x08"sv, "", "compressed twice", Way::through, "zstdcat FILE"},
    ForeignFormat{0, "\x28\xb5\x2f\xfd"sv, "", "compressed twice", Way::through, "zstdcat FILE"},
    ForeignFormat{0, "\x1f\x9d"sv, "", "compressed by compress", Way::through, "zcat FILE"},

    ForeignFormat{0, "Kaydara FBX Binary"sv, "", "an FBX scene", Way::exported},
    ForeignFormat{text_begin, "; fbx "sv, "", "an FBX scene", Way::exported},
    ForeignFormat{text_begin, "<collada"sv, "", "a COLLADA (DAE) scene", Way::exported},
    ForeignFormat{text_begin, "<?xml"sv, "<COLLADA", "a COLLADA (DAE) scene", Way::exported},
    ForeignFormat{text_begin, "<?xml"sv, "<X3D", "an X3D scene", Way::exported},
    ForeignFormat{text_begin, "#x3d"sv, "", "an X3D scene", Way::exported},
    ForeignFormat{text_begin, "#vrml"sv, "", "a VRML scene", Way::exported},
    ForeignFormat{text_begin, "<?xml"sv, "<amf", "an AMF model", Way::exported},
    ForeignFormat{text_begin, "# vtk datafile"sv, "", "a VTK file", Way::exported},
    ForeignFormat{text_begin, "<vtkfile"sv, "", "a VTK file", Way::exported},
    ForeignFormat{text_begin, "<?xml"sv, "<VTKFile", "a VTK file", Way::exported},
    ForeignFormat{text_begin, "iso-10303-21"sv, "", "a STEP model", Way::exported},
    ForeignFormat{text_begin, "$meshformat"sv, "", "a Gmsh mesh", Way::exported},
    ForeignFormat{text_begin, "meshversionformatted"sv, "", "a Medit mesh", Way::exported},
    ForeignFormat{text_begin, "#usda"sv, "", "a USD scene", Way::exported},
    ForeignFormat{0, "PXR-USDC"sv, "", "a USD scene", Way::exported},
    ForeignFormat{0, "Ogawa"sv, "", "an Alembic scene", Way::exported},
    ForeignFormat{0, "BLENDER"sv, "", "a Blender file", Way::exported},
    ForeignFormat{0, "3D Geometry File Format"sv, "", "a Rhino (3DM) model", Way::exported},
    ForeignFormat{0, "DRACO"sv, "", "a Draco mesh", Way::exported},

    ForeignFormat{0, "LASF"sv, "laszip encoded", "a LAZ point cloud", Way::reconstructed},
    ForeignFormat{0, "LASF"sv, "", "a LAS point cloud", Way::reconstructed},
    ForeignFormat{0, "ASTM-E57"sv, "", "an E57 point cloud", Way::reconstructed},
    ForeignFormat{text_begin, "# .pcd"sv, "", "a PCD point cloud", Way::reconstructed},

    ForeignFormat{0, "\x89WPM\r\n\x1a\n"sv, "", "a progressive mesh", Way::extracted},
    ForeignFormat{0, "\x89PNG\r\n\x1a\n"sv, "", "a PNG image", Way::none},
    ForeignFormat{0, "\xff\xd8\xff"sv, "", "a JPEG image", Way::none},
    ForeignFormat{0, "GIF8"sv, "", "a GIF image", Way::none},
    ForeignFormat{0, "II*\0"sv, "", "a TIFF image", Way::none},
    ForeignFormat{0, "MM\0*"sv, "", "a TIFF image", Way::none},
    ForeignFormat{0, "%PDF-"sv, "", "a PDF document", Way::none},
    ForeignFormat{0, "\x89HDF\r\n\x1a\n"sv, "", "an HDF5 file", Way::none},
    ForeignFormat{0, "SQLite format 3\0"sv, "", "an SQLite database", Way::none},
    ForeignFormat{0, "\x7f\x45LF"sv, "", "a program", Way::none},
    ForeignFormat{text_begin, "<!doctype html"sv, "", "a web page (HTML)", Way::none,
                  "; was the download refused?"},
    ForeignFormat{text_begin, "<html"sv, "", "a web page (HTML)", Way::none,
                  "; was the download refused?"},
    ForeignFormat{text_begin, "<?xml"sv, "<html", "a web page (HTML)", Way::none,
                  "; was the download refused?"},
    ForeignFormat{text_begin, "<?xml"sv, "", "an XML file", Way::none},
    ForeignFormat{text_begin, "version https://git-lfs"sv, "", "a Git LFS pointer", Way::none,
                  "; git lfs pull fetches the file that it stands for"},

    ForeignFormat{0, "\xff\xfe\0\0"sv, "", "text in UTF-32", Way::through,
                  "iconv -f UTF-32 -t UTF-8 FILE"},
    ForeignFormat{0, "\0\0\xfe\xff"sv, "", "text in UTF-32", Way::through,
                  "iconv -f UTF-32 -t UTF-8 FILE"},
    ForeignFormat{0, "\xff\xfe"sv, "", "text in UTF-16", Way::through,
                  "iconv -f UTF-16 -t UTF-8 FILE"},
    ForeignFormat{0, "\xfe\xff"sv, "", "text in UTF-16", Way::through,
                  "iconv -f UTF-16 -t UTF-8 FILE"}};

std::string_view text_of_block(const Block& block) {
  return {reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size()};
}

bool begins_with(std::string_view head, const ForeignFormat& format) {
  if (format.at != text_begin)
    return head.substr(std::min(format.at, head.size())).starts_with(format.magic);
  head = without_byte_order_mark(head);
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  return std::equal(
      format.magic.begin(), format.magic.end(), head.begin(),
      head.begin() + static_cast<std::ptrdiff_t>(std::min(format.magic.size(), head.size())),
      [](char small, char c) { return small == ascii_to_lower(c); });
}

[[noreturn]] void refuse(const ByteSource& source, const ForeignFormat& format) {
  std::string message = "'" + source.name() + "' is " + format.what;
  switch (format.way) {
    case Way::through:
      message += std::string(", which winnow does not read: ") + format.more +
                 " | winnow simplify - -o OUTPUT";
      break;
    case Way::extracted:
      message += ", of which `extract` makes a mesh";
      break;
    case Way::exported:
      message += ", which winnow does not read; export it as PLY, STL, OBJ or GLB";
      break;
    case Way::reconstructed:
      message += ", which has no faces; make a surface of it first, by Poisson reconstruction say";
      break;
    case Way::none:
      message += std::string(", not a mesh") + format.more;
  }
  throw Error(ErrorKind::bad_input, message);
}

// Without a mark: in every pair of bytes one that is 0, always the same, and one that is not.
std::string_view unmarked_utf16(std::string_view head) {
  head = head.substr(0, 64);
  if (head.size() < 8) return "";
  const bool big = head[0] == 0;
  for (std::size_t i = 0; i + 1 < head.size(); i += 2) {
    if ((head[i + (big ? 0 : 1)] != 0) || !is_text(head.substr(i + (big ? 1 : 0), 1))) return "";
  }
  return big ? "UTF-16BE" : "UTF-16LE";
}

}  // namespace

void refuse_foreign(ByteSource& source) {
  const Block block = source.peek(1024);
  const std::string_view head = text_of_block(block);
  for (const ForeignFormat& format : foreign_formats) {
    if (!begins_with(head, format)) continue;
    if (format.inside.empty()) refuse(source, format);
    const Block more = source.peek(text_head_bytes);
    if (text_of_block(more).find(format.inside) != std::string_view::npos) refuse(source, format);
  }
  const std::string_view encoding = unmarked_utf16(head);
  if (encoding.empty()) return;
  const std::string command = "iconv -f " + std::string(encoding) + " -t UTF-8 FILE";
  refuse(source, {0, "", "", "text in UTF-16", Way::through, command.c_str()});
}

std::string kind_of_text(std::string_view head) {
  TextLines each(head);
  std::size_t rows = 0;
  for (std::string_view line; rows < 3 && each.next(line);) {
    LineWords words(line);
    std::size_t numbers = 0;
    for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++numbers) {
      if (!parse_real(word)) return "it is some other text";
    }
    rows += numbers >= 2 ? 1 : 0;
  }
  return rows == 0
             ? "it is some other text"
             : "it is rows of numbers, as of a point cloud or a grid of heights, and has no faces";
}

}  // namespace winnow
