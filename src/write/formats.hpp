// The formats that can be written. A new one is a file of its own and its line in this one.
#pragma once

#include <winnow/format.hpp>

#include "write/mesh_encoder.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

namespace winnow {

enum class TextForm { never, always, by_choice };  // the choice is Encoding::ascii

struct OutputFormat {
  std::unique_ptr<MeshEncoder> (*make)(const Encoding& encoding);
  // What is written, for people: "PLY ASCII". Null: its name alone.
  const char* (*described)(const Encoding& encoding) = nullptr;
  TextForm text = TextForm::always;
  bool doubles = true;   // positions may be doubles
  bool for_web = false;  // has compress, quantize and up
};

extern const OutputFormat ply_output;
extern const OutputFormat stl_output;
extern const OutputFormat obj_output;
extern const OutputFormat off_output;
extern const OutputFormat m_output;
extern const OutputFormat glb_output;

inline constexpr std::array<std::pair<Format, const OutputFormat*>, 6> output_formats{
    {{Format::ply, &ply_output},
     {Format::stl, &stl_output},
     {Format::obj, &obj_output},
     {Format::off, &off_output},
     {Format::m, &m_output},
     {Format::gltf, &glb_output}}};

constexpr const OutputFormat* output_format(Format format) {
  for (const auto& [known, output] : output_formats) {
    if (known == format) return output;
  }
  return nullptr;
}
static_assert(std::ranges::all_of(all_values<Format>(), [](Format format) {
  const auto listed = [format](const auto& entry) { return entry.first == format; };
  return serves(format, FormatUse::written) == std::ranges::any_of(output_formats, listed);
}));

// The encoder for `format`; with Format::automatic for what the name ends in (before .gz or .zst),
// PLY where that says nothing. Throws Error(usage) where `encoding` asks for what the format does
// not have.
std::unique_ptr<MeshEncoder> make_encoder(Format format, const std::string& path,
                                          const Encoding& encoding = {});

// What the encoder of the same arguments writes, for people: "PLY ASCII, gzip".
std::string format_written(Format format, const std::string& path, const Encoding& encoding = {});

// Whether that is text, which a terminal can show.
bool writes_text(Format format, const std::string& path, const Encoding& encoding = {});

// Throws Error(usage) where a progressive file would be named like a mesh or an archive.
void check_progressive_name(const std::string& path);

}  // namespace winnow
