// What the header of a progressive file says.
#include "run/progressive_info.hpp"

#include "base/text.hpp"
#include "progressive/file_header.hpp"
#include "run/attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace winnow {

namespace {

std::string positions_of(const PositionForm& form) {
  if (form.bits > 0) return std::to_string(form.bits) + " bits";
  return form.doubles ? "double" : "float";
}

}  // namespace

bool is_progressive(const std::string& input) {
  // A pipe is read once.
  std::error_code none;
  if (!std::filesystem::is_regular_file(input, none)) return false;
  std::ifstream file(input, std::ios::binary);
  std::array<char, progressive_magic.size()> head{};
  file.read(head.data(), head.size());
  return file &&
         std::equal(head.begin(), head.end(), progressive_magic.begin(),
                    [](char c, std::uint8_t byte) { return static_cast<std::uint8_t>(c) == byte; });
}

ProgressiveInfo progressive_info(Context& context, const std::string& input) {
  Job job(context);
  const std::unique_ptr<ByteSource> source = open_source(job, input);
  return info_of_progressive(job, *source, input);
}

ProgressiveInfo info_of_progressive(Job& job, ByteSource& source, const std::string& input) {
  const ProgressiveHeader header = read_header(job, source);
  ProgressiveInfo info;
  const ProgressiveHeader::Counts all = header.all(), base = header.base();
  info.name = input;
  info.format = "progressive mesh, version " + std::to_string(progressive_version);
  info.bytes = all.bytes;
  info.faces = all.faces;
  info.vertices = all.vertices;
  info.base_faces = base.faces;
  info.base_vertices = base.vertices;
  info.chunks = header.chunks.size();
  info.cost = header.cost;
  info.positions = positions_of(header.form);
  info.box_min = header.box.low;
  info.box_max = header.box.high;
  AttributeSelection choice;
  choice.carried = header.attributes;
  info.attributes = descriptions(choice);
  const auto add = [&](std::uint64_t faces) {
    const std::size_t chunks = header.chunks_for(faces);
    ProgressiveInfo::Prefix& prefix = info.prefixes.emplace_back();
    prefix.faces = faces;
    prefix.bytes = header.counts(chunks).bytes;
    if (std::isfinite(header.error_of(chunks))) prefix.error = header.error_of(chunks);
  };
  for (std::uint64_t faces = base.faces; faces < all.faces && faces > 0; faces *= 10) add(faces);
  add(all.faces);
  if (source.size() && *source.size() < all.bytes) {
    std::size_t whole = header.base_chunks;
    while (whole < header.chunks.size() && header.counts(whole + 1).bytes <= *source.size())
      ++whole;
    info.notes.push_back("the file is cut short: " + grouped(*source.size()) + " of " +
                         grouped(all.bytes) + " bytes are there" +
                         (header.base().bytes <= *source.size()
                              ? ", enough for " + grouped(header.counts(whole).faces) + " faces"
                              : ""));
  }
  return info;
}

}  // namespace winnow
