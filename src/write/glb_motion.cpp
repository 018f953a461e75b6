#include "write/glb_motion.hpp"

#include "base/srgb.hpp"
#include "base/text.hpp"
#include "write/append.hpp"
#include "write/glb_text.hpp"

#include <string>

#include <nlohmann/json.hpp>

namespace winnow {

namespace {

// Zeros are left out where that is shorter: a weight then has its place beside it.
bool is_sparse(const GlbMotion& motion, const MorphClip& clip) {
  return 2 * clip.weights.size() < clip.rows() * motion.moves.size();
}

std::uint64_t weight_bytes(const GlbMotion& motion, const MorphClip& clip) {
  const std::uint64_t numbers =
      is_sparse(motion, clip) ? 2 * clip.weights.size() : clip.rows() * motion.moves.size();
  return numbers * sizeof(float);
}

std::uint64_t time_bytes(const MorphClip& clip) {
  return clip.times.size() * sizeof(float);
}

std::uint64_t clip_bytes(const GlbMotion& motion) {
  std::uint64_t bytes = 0;
  for (const MorphClip& clip : motion.clips) bytes += time_bytes(clip) + weight_bytes(motion, clip);
  return bytes;
}

std::uint64_t target_bytes(const GlbMotion& motion) {
  return motion.moves.size() * motion.vertices * motion.stride();
}

std::string slice(std::size_t view, std::uint64_t offset) {
  return R"("bufferView":)" + glb_number(view) + R"(,"byteOffset":)" + glb_number(offset);
}

const std::string floats = R"(,"componentType":5126,"count":)";

std::string weights_accessor(const GlbMotion& motion, const MorphClip& clip, std::size_t view,
                             std::uint64_t at) {
  const std::string count =
      floats + glb_number(clip.rows() * motion.moves.size()) + R"(,"type":"SCALAR")";
  if (!is_sparse(motion, clip)) return "{" + slice(view, at) + count + "}";
  const std::uint64_t places = clip.places.size();
  if (places == 0) return "{" + count.substr(1) + "}";
  return "{" + count.substr(1) + R"(,"sparse":{"count":)" + glb_number(places) + R"(,"indices":{)" +
         slice(view, at) + R"(,"componentType":5125},"values":{)" +
         slice(view, at + places * sizeof(std::uint32_t)) + "}}}";
}

const char* interpolation(MorphClip::Between between) {
  switch (between) {
    case MorphClip::Between::linear:
      return "LINEAR";
    case MorphClip::Between::step:
      return "STEP";
    case MorphClip::Between::cubic:
      return "CUBICSPLINE";
  }
  return "";
}

}  // namespace

std::uint64_t GlbMotion::bytes() const {
  return target_bytes(*this) + clip_bytes(*this);
}

void emit_glb_targets(const GlbMotion& motion, std::size_t first, const Emit& emit) {
  emit(R"(,"targets":[)");
  const std::size_t each = motion.each_accessors();
  for (std::size_t t = 0; t < motion.moves.size(); ++t) {
    emit((t > 0 ? R"(,{"POSITION":)" : R"({"POSITION":)") + glb_number(first + each * t));
    if (motion.normals) emit(R"(,"NORMAL":)" + glb_number(first + each * t + 1));
    if (motion.colors > 0) emit(R"(,"COLOR_0":)" + glb_number(first + each * (t + 1) - 1));
    emit("}");
  }
  emit("]");
}

void emit_motion_accessors(const GlbMotion& motion, std::size_t view, const Emit& emit) {
  for (std::size_t t = 0; t < motion.moves.size(); ++t) {
    const std::uint64_t at = t * motion.vertices * motion.stride();
    const std::string count = floats + glb_number(motion.vertices) + R"(,"type":"VEC)";
    const std::string vectors = count + "3\"";
    const Box& box = motion.moves[t];
    emit(",{" + slice(view, at) + vectors + R"(,"min":)" + glb_list(box.low) + R"(,"max":)" +
         glb_list(box.high) + "}");
    if (motion.normals) emit(",{" + slice(view, at + 3 * sizeof(float)) + vectors + "}");
    if (motion.colors == 0) continue;
    const std::uint64_t colors = at + motion.stride() - motion.colors * sizeof(float);
    emit(",{" + slice(view, colors) + count + glb_number(motion.colors) + "\"}");
  }
  std::uint64_t at = 0;
  for (const MorphClip& clip : motion.clips) {
    emit(",{" + slice(view + 1, at) + floats + glb_number(clip.times.size()) +
         R"(,"type":"SCALAR","min":[)" + shortest(clip.times.front()) + R"(],"max":[)" +
         shortest(clip.times.back()) + "]},");
    at += time_bytes(clip);
    emit(weights_accessor(motion, clip, view + 1, at));
    at += weight_bytes(motion, clip);
  }
}

void emit_motion_views(const GlbMotion& motion, std::uint64_t begin, const Emit& emit) {
  const auto view = [&](std::uint64_t bytes) {
    std::string text = R"(,{"buffer":0,"byteOffset":)" + glb_number(begin) + R"(,"byteLength":)" +
                       glb_number(bytes);
    begin += bytes;
    return text;
  };
  emit(view(target_bytes(motion)) + R"(,"byteStride":)" + glb_number(motion.stride()) +
       R"(,"target":34962})");
  if (!motion.clips.empty()) emit(view(clip_bytes(motion)) + "}");
}

void emit_glb_animations(const GlbMotion& motion, std::size_t first, const Emit& emit) {
  if (motion.clips.empty()) return;
  emit(R"(,"animations":[)");
  for (std::size_t i = 0; i < motion.clips.size(); ++i) {
    const MorphClip& clip = motion.clips[i];
    emit(i > 0 ? ",{" : "{");
    if (!clip.name.empty()) emit(R"("name":)" + nlohmann::json(clip.name).dump() + ",");
    const std::size_t times = first + motion.target_accessors() + 2 * i;
    emit(R"("samplers":[{"input":)" + glb_number(times) + R"(,"interpolation":")" +
         interpolation(clip.between) + R"(","output":)" + glb_number(times + 1) +
         R"(}],"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}]})");
  }
  emit("]");
}

GlbMove glb_move(const GlbLayout& layout, const VertexColors& colors, const MeshVertex& from,
                 const MeshVertex& to) {
  const Point first = written_position(from.position, layout);
  const Point later = written_position(to.position, layout);
  const std::array<float, 3> first_normal = unit_normal(from.normal);
  const std::array<float, 3> later_normal = unit_normal(to.normal);
  GlbMove move;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    move.position[axis] = static_cast<float>(later[axis] - first[axis]);
    move.normal[axis] = later_normal[axis] - first_normal[axis];
  }
  for (std::size_t i = 0; i < move.color.size() && colors.any(); ++i) {
    const auto written = [&](const MeshVertex& vertex) {
      const double component = colors.component(vertex, i);
      return i < 3 ? light_of_component(component) : component;
    };
    move.color[i] = static_cast<float>(written(to) - written(from));
  }
  return move;
}

void append_move(const GlbMotion& motion, const GlbMove& move, std::vector<std::byte>& out) {
  append(out, move.position);
  if (motion.normals) append(out, move.normal);
  for (unsigned i = 0; i < motion.colors; ++i) append(out, move.color.at(i));
}

void append_clips(const GlbMotion& motion, std::vector<std::byte>& out) {
  for (const MorphClip& clip : motion.clips) {
    for (const float time : clip.times) append(out, time);
    if (is_sparse(motion, clip)) {
      for (const std::uint32_t place : clip.places) append(out, place);
      for (const float weight : clip.weights) append(out, weight);
    } else {
      std::size_t next = 0;
      for (std::uint64_t i = 0; i < clip.rows() * motion.moves.size(); ++i) {
        const bool given = next < clip.places.size() && clip.places[next] == i;
        append(out, given ? clip.weights[next] : 0.0F);
        if (given) ++next;
      }
    }
  }
}

}  // namespace winnow
