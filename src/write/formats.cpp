#include "write/formats.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "io/compressing.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace winnow {

namespace {

// "PLY, OBJ or OFF": the names, or the endings, of the formats that `has` holds of.
std::string list_of(const std::function<bool(const OutputFormat&)>& has, bool endings = false) {
  std::vector<std::string> names;
  for (const auto& [format, output] : output_formats) {
    const FormatFacts facts = facts_of(format);
    if (has(*output))
      names.push_back(endings ? std::string(".") + facts.endings[0] : facts.written);
  }
  return either(names);
}

// What is no ending of a mesh that is written, but of one in another format, or of an archive.
constexpr std::array other_endings{".gltf", ".3mf",  ".dae", ".fbx",  ".3ds",  ".wrl",  ".x3d",
                                   ".vtk",  ".vtp",  ".usd", ".usda", ".usdc", ".usdz", ".stp",
                                   ".step", ".iges", ".las", ".laz",  ".e57",  ".xyz",  ".pcd",
                                   ".pts",  ".json", ".bz2", ".xz",   ".zip",  ".7z",   ".lz4"};
constexpr const char* progressive_ending = ".wpm";

// As it stands behind the last dot, in small letters; without what compresses the file.
std::string ending_of(const std::string& path) {
  const std::string name = std::filesystem::path(without_compression(path)).filename().string();
  const std::size_t dot = name.rfind('.');
  std::string ending = dot == std::string::npos ? "" : name.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(), ascii_to_lower);
  return ending;
}

bool is_other(const std::string& ending) {
  return std::find(other_endings.begin(), other_endings.end(), ending) != other_endings.end();
}

// Of a mesh that is written.
std::optional<Format> format_ending_with(const std::string& ending) {
  for (const auto& [format, output] : output_formats) {
    if (ending == std::string(".") + facts_of(format).endings[0]) return format;
  }
  return {};
}

Format format_of_name(const std::string& path) {
  const std::string ending = ending_of(path);
  if (const auto format = format_ending_with(ending)) return *format;
  const bool progressive = ending == progressive_ending;
  if (!progressive && !is_other(ending)) return Format::ply;
  throw Error(ErrorKind::usage,
              "'" + path + "': " + ending + " is not written; name the output " +
                  list_of([](const OutputFormat&) { return true; }, true) +
                  (progressive ? "; `progressive` writes .wpm" : ", or say `to` ply"));
}

struct Chosen {
  Format format;
  const OutputFormat& output;
  FormatFacts facts = facts_of(format);
};

Chosen choose(Format format, const std::string& path) {
  if (format == Format::automatic) format = format_of_name(path);
  const OutputFormat* const output = output_format(format);
  if (output == nullptr) {
    throw Error(ErrorKind::usage, std::string(facts_of(format).name) + " is not written; choose " +
                                      list_of([](const OutputFormat&) { return true; }));
  }
  return {format, *output};
}

void check(const Encoding& encoding, const Chosen& chosen) {
  const OutputFormat& output = chosen.output;
  const std::string name = chosen.facts.written;
  const std::string web = list_of([](const OutputFormat& other) { return other.for_web; });
  if (!output.doubles && encoding.positions == Positions::doubles) {
    throw Error(ErrorKind::usage,
                name + " holds floats, not doubles; choose " +
                    list_of([](const OutputFormat& other) { return other.doubles; }));
  }
  if (output.text == TextForm::never && encoding.ascii) {
    throw Error(ErrorKind::usage,
                name + " has no text form; choose " + list_of([](const OutputFormat& other) {
                  return other.text != TextForm::never;
                }));
  }
  if (encoding.compress != Compression::none && !output.for_web) {
    throw Error(ErrorKind::usage, "meshopt compression is for " + web +
                                      " alone; name the output .gz or .zst instead");
  }
  if (encoding.quantize && !output.for_web) {
    throw Error(ErrorKind::usage,
                "`quantize` is for " + web + " alone; other formats hold floats or doubles");
  }
  if (encoding.quantize && (*encoding.quantize < 1 || *encoding.quantize > 16)) {
    throw Error(ErrorKind::usage,
                "`quantize` takes 1 to 16 bits, not " + std::to_string(*encoding.quantize));
  }
  if (encoding.up == UpAxis::z && !output.for_web) {
    throw Error(ErrorKind::usage, "`up` z is for " + web +
                                      " alone, in which y points up; other formats keep the axes "
                                      "as they are");
  }
}

}  // namespace

std::unique_ptr<MeshEncoder> make_encoder(Format format, const std::string& path,
                                          const Encoding& encoding) {
  const Chosen chosen = choose(format, path);
  check(encoding, chosen);
  return chosen.output.make(encoding);
}

bool writes_text(Format format, const std::string& path, const Encoding& encoding) {
  const TextForm text = choose(format, path).output.text;
  return (text == TextForm::always || (text == TextForm::by_choice && encoding.ascii)) &&
         without_compression(path) == path;
}

std::string format_written(Format format, const std::string& path, const Encoding& encoding) {
  const Chosen chosen = choose(format, path);
  const OutputFormat& output = chosen.output;
  std::string name =
      output.described != nullptr ? output.described(encoding) : chosen.facts.written;
  const std::string plain = without_compression(path);
  if (plain != path) name += path.ends_with("zst") ? ", zstd" : ", gzip";
  return name;
}

void check_progressive_name(const std::string& path) {
  const std::string ending = ending_of(path);
  if (!format_ending_with(ending) && !is_other(ending)) return;
  throw Error(ErrorKind::usage, "'" + path + "': a progressive file is no " + ending +
                                    "; name it .wpm, and `extract` writes meshes of it");
}

}  // namespace winnow
