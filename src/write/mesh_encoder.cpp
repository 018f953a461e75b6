#include "write/mesh_encoder.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "io/compressing.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace winnow {

namespace {

constexpr std::array<std::pair<const char*, Format>, 6> endings{{{".ply", Format::ply},
                                                                 {".stl", Format::stl},
                                                                 {".obj", Format::obj},
                                                                 {".off", Format::off},
                                                                 {".m", Format::m},
                                                                 {".glb", Format::gltf}}};

Format format_called(const std::string& path) {
  const std::string name = std::filesystem::path(without_compression(path)).filename().string();
  const std::size_t dot = name.rfind('.');
  std::string ending = dot == std::string::npos ? "" : name.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(), ascii_to_lower);
  for (const auto& [known, format] : endings) {
    if (ending == known) return format;
  }
  for (const char* other :
       {".gltf", ".3mf",  ".dae",  ".fbx", ".3ds",  ".wrl",  ".x3d", ".vtk", ".vtp", ".usd",
        ".usda", ".usdc", ".usdz", ".stp", ".step", ".iges", ".las", ".laz", ".e57", ".xyz",
        ".pcd",  ".pts",  ".json", ".bz2", ".xz",   ".zip",  ".7z",  ".lz4"}) {
    if (ending != other) continue;
    throw Error(
        ErrorKind::usage,
        "'" + path + "': " + other +
            " is not written; name the output .ply, .stl, .obj, .off, .m or .glb, or say `to` ply");
  }
  return Format::ply;
}

}  // namespace

std::unique_ptr<MeshEncoder> make_encoder(Format format, const std::string& path,
                                          const Encoding& encoding) {
  if (format == Format::automatic) format = format_called(path);
  const bool floats = format == Format::stl || format == Format::gltf;
  if (floats && encoding.positions == Positions::doubles) {
    throw Error(ErrorKind::usage, std::string(format == Format::stl ? "STL" : "GLB") +
                                      " holds floats, not doubles; choose PLY, OBJ or OFF");
  }
  if (format == Format::gltf && encoding.ascii)
    throw Error(ErrorKind::usage, "GLB has no text form; choose PLY, STL, OBJ or OFF");
  const bool packed = encoding.compress == Compression::meshopt;
  if (packed && format != Format::gltf)
    throw Error(ErrorKind::usage,
                "meshopt compression is for GLB alone; name the output .gz or .zst instead");
  if (encoding.quantize && format != Format::gltf)
    throw Error(ErrorKind::usage,
                "`quantize` is for GLB alone; other formats hold floats or doubles");
  if (encoding.quantize && (*encoding.quantize < 1 || *encoding.quantize > 16)) {
    throw Error(ErrorKind::usage,
                "`quantize` takes 1 to 16 bits, not " + std::to_string(*encoding.quantize));
  }
  if (encoding.up == UpAxis::z && format != Format::gltf) {
    throw Error(
        ErrorKind::usage,
        "`up` z is for GLB alone, in which y points up; other formats keep the axes as they are");
  }
  switch (format) {
    case Format::stl:
      return make_stl_encoder(encoding.ascii);
    case Format::obj:
      return make_obj_encoder();
    case Format::off:
      return make_off_encoder();
    case Format::m:
      return make_m_encoder();
    case Format::gltf:
      return packed ? make_packed_glb_encoder(encoding) : make_glb_encoder(encoding);
    default:
      return make_ply_encoder(encoding.ascii);
  }
}

bool writes_text(Format format, const std::string& path, const Encoding& encoding) {
  if (format == Format::automatic) format = format_called(path);
  const bool text =
      encoding.ascii || (format != Format::ply && format != Format::stl && format != Format::gltf);
  return text && without_compression(path) == path;
}

std::string format_written(Format format, const std::string& path, const Encoding& encoding) {
  if (format == Format::automatic) format = format_called(path);
  std::string name;
  switch (format) {
    case Format::stl:
      name = encoding.ascii ? "STL ASCII" : "STL binary";
      break;
    case Format::obj:
      name = "OBJ";
      break;
    case Format::off:
      name = "OFF";
      break;
    case Format::gltf:
      name = encoding.compress == Compression::meshopt ? "GLB, meshopt" : "GLB";
      break;
    case Format::m:
      name = ".m";
      break;
    default:
      name = encoding.ascii ? "PLY ASCII" : "PLY binary little-endian";
  }
  const std::string plain = without_compression(path);
  if (plain != path) name += path.ends_with("zst") ? ", zstd" : ", gzip";
  return name;
}

}  // namespace winnow
