#include "read/morph_frames.hpp"

#include <winnow/error.hpp>

#include "base/text.hpp"
#include "io/byte_source.hpp"
#include "read/formats.hpp"
#include "read/gltf/accessor.hpp"
#include "read/gltf/bytes.hpp"
#include "read/gltf/reader.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace winnow {

namespace {

class GltfMorphFrames final : public MorphFrames {
 public:
  GltfMorphFrames(Job& job, std::string name, ByteSource& source)
      : job_(job),
        name_(std::move(name)),
        file_(peek_gltf(job, source)),
        attributes_(attributes_of(file_.document)) {
    for (const GltfPlacedMesh& placed : file_.document.placed) count_targets(placed);
    if (targets_ == 0)
      throw Error(ErrorKind::bad_input,
                  "'" + name_ +
                      "' has no morph targets; a sequence needs some, or the files of several "
                      "frames");
    std::erase(attributes_.unread, unread_targets);
    if (file_.document.weights_alone) std::erase(attributes_.unread, unread_animations);
  }

  [[nodiscard]] std::size_t frames() const override { return targets_ + 1; }

  std::unique_ptr<MeshReader> open(std::size_t frame, const ReaderMemory& memory,
                                   const AttributeRequest& wish) override {
    std::optional<std::size_t> target;
    if (frame > 0) target = frame - 1;
    AttributeRequest own = wish;
    if (!normals_move_) {
      own.refusal = [others = wish.refusal](const Attribute& attribute,
                                            std::span<const Attribute> wanted) -> std::string {
        if (names_normal(attribute)) return "normals that do not move with the targets:";
        return others ? others(attribute, wanted) : "";
      };
    }
    return open_gltf_document(job_, seekable_source(), memory, own, file_, attributes_, target);
  }

  std::vector<MorphClip> clips() override {
    std::vector<MorphClip> clips;
    if (file_.document.weights.empty()) return clips;
    if (moving_nodes_ > 1) {
      job_.note("the animations of " + grouped(moving_nodes_) +
                " meshes are replaced by one that plays all targets one after the other");
      return clips;
    }
    const std::unique_ptr<ByteSource> source = seekable_source();
    const GltfOwnBuffer own = own_buffer_of(*source, file_);
    GltfBytes bytes(job_, *source, own.begin, own.bytes, file_.document);
    for (const GltfWeights& weights : file_.document.weights) {
      if (weights.node == moving_node_) clips.push_back(clip_of(weights, bytes));
    }
    return clips;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorKind::bad_input, "'" + name_ + "': " + what);
  }

  void count_targets(const GltfPlacedMesh& placed) {
    bool moves = false;
    for (const GltfPrimitive& primitive : file_.document.meshes[placed.mesh]) {
      if (primitive.targets.empty()) continue;
      moves = true;
      if (targets_ == 0) targets_ = primitive.targets.size();
      if (targets_ != primitive.targets.size())
        fail("its meshes have " + grouped(targets_) + " and " + grouped(primitive.targets.size()) +
             " morph targets; a sequence needs the same number in all that have some");
      for (const GltfPrimitive::Target& target : primitive.targets)
        normals_move_ &= target.normals || !target.positions;
    }
    if (!moves) return;
    moving_node_ = placed.node;
    ++moving_nodes_;
  }

  [[nodiscard]] std::unique_ptr<ByteSource> seekable_source() const {
    std::unique_ptr<ByteSource> source = open_source(job_, name_);
    return source->seekable() ? std::move(source) : copy_to_scratch(job_, std::move(source));
  }

  MorphClip clip_of(const GltfWeights& weights, GltfBytes& bytes) {
    const GltfAccessor& numbers = file_.document.accessors[weights.weights];
    const std::uint64_t given = numbers.base     ? numbers.count
                                : numbers.sparse ? numbers.sparse->count
                                                 : 0;
    const std::uint64_t times = file_.document.accessors[weights.times].count;
    memory_.push_back(job_.budget.reserve(sizeof(float) * (times + 2 * given), "an animation"));
    MorphClip clip;
    clip.name = weights.name;
    clip.between = weights.between;
    for_each(weights.times, bytes, [&](std::uint64_t /*place*/, float time) {
      if (!(clip.times.empty() ? time >= 0 : time > clip.times.back()))
        fail("the times of an animation are not in ascending order");
      clip.times.push_back(time);
    });
    if (clip.times.empty() || numbers.count != clip.rows() * targets_ || numbers.count > UINT32_MAX)
      fail("an animation has " + grouped(numbers.count) + " weights for " +
           grouped(clip.times.size()) + " times and " + grouped(targets_) + " targets");
    for_each(weights.weights, bytes, [&](std::uint64_t place, float weight) {
      if (!std::isfinite(weight)) fail("a weight of an animation is not finite");
      if (weight == 0) return;
      clip.places.push_back(static_cast<std::uint32_t>(place));
      clip.weights.push_back(weight);
    });
    return clip;
  }

  template <typename Each>
  void for_each(std::size_t accessor, GltfBytes& bytes, const Each& each) {
    bytes.begin_part();
    GltfElements elements(bytes, file_.document, accessor, GltfUse::numbers, name_);
    std::uint64_t place = 0;
    for (auto part = elements.next(); !part.empty(); part = elements.next()) {
      job_.progress.check_cancelled();
      for (const double number : part) each(place++, static_cast<float>(number));
    }
  }

  Job& job_;
  std::string name_;
  GltfFile file_;
  GltfAttributes attributes_;
  std::size_t targets_ = 0;
  bool normals_move_ = true;     // wherever positions do
  std::size_t moving_node_ = 0;  // the last with targets
  std::uint64_t moving_nodes_ = 0;
  std::vector<Reservation> memory_;  // of clips
};

}  // namespace

std::unique_ptr<MorphFrames> open_morph_frames(Job& job, const std::string& name, Format from) {
  const std::unique_ptr<ByteSource> source = open_source(job, name);
  if (format_of(*source, from) != Format::gltf) return nullptr;
  return std::make_unique<GltfMorphFrames>(job, name, *source);
}

}  // namespace winnow
