#include "sequence/frame_intake.hpp"

#include <winnow/error.hpp>

#include "base/hash.hpp"
#include "base/text.hpp"
#include "decimate/frames.hpp"
#include "io/sorted_records.hpp"
#include "io/spool_records.hpp"
#include "mesh/ordered_face.hpp"
#include "read/for_each_batch.hpp"
#include "sequence/vertex_order.hpp"
#include "write/append.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

namespace winnow {

namespace {

constexpr std::uint64_t bytes_at_once = std::uint64_t{1} << 20;

std::string corners_of(const FaceVertices& face) {
  return std::to_string(face[0]) + ", " + std::to_string(face[1]) + " and " +
         std::to_string(face[2]);
}

std::uint64_t bits_of(double x) {
  return std::bit_cast<std::uint64_t>(x + 0.0);  // not -0, which is the same place
}

}  // namespace

FrameIntake::FrameIntake(Job& job, FrameReaders& readers, const IntakeMemory& memory)
    : job_(job),
      readers_(readers),
      memory_(memory),
      carried_(job, memory.frames / 2),
      frames_(std::make_unique<Spool>(job, memory.frames)),
      raw_faces_(job, memory.mesh / 4),
      cut_faces_(job, memory.mesh / 4) {}

SequenceMesh FrameIntake::run(const Refuse& refuse, const FrameAttributes::Settle& settle) {
  refuse_ = &refuse;
  settle_ = &settle;
  ReaderMemory reading = memory_.reader;
  reading.polygons_as_fans = true;
  job_.progress.begin("read frames", 0, "vertices");
  for (;;) {
    std::unique_ptr<MeshReader> reader = readers_.next(reading);
    if (reader == nullptr) break;
    out_.double_positions |= reader->facts().double_positions;
    if (out_.frames == 0) {
      add_first(*reader);
    } else {
      add_later(*reader);
    }
    out_.bytes += reader->bytes();
    reader->check_whole();
    ++out_.frames;
    reader.reset();
    if (out_.frames > 1 || !polygons_) continue;
    reader = readers_.again(memory_.reader);
    read_faces(*reader, cut_faces_);
    cut_faces_.finish();
  }
  if (out_.frames == 0) throw Error(ErrorKind::usage, "a sequence needs at least one frame");
  frames_->finish();
  position_ = {};
  carried_.finish(out_.dropped.dropped);
  out_.attributes = carried_.carried();
  if (carried_.not_finite() > 0)
    job_.note(grouped(carried_.not_finite()) +
              " numbers of carried attributes are not finite; 0 was taken for them");
  job_.progress.begin("order vertices", out_.vertices, "vertices");
  join_vertices();
  const Spool& faces = polygons_ ? cut_faces_ : raw_faces_;
  number_used(faces);
  const MeshLayout layout{Frames::saved_size(out_.frames), out_.frames * out_.attributes.size()};
  out_.mesh = StoredMesh(job_, layout, MeshMemory::divide(memory_.mesh / 2));
  write_vertices(out_.mesh);
  write_faces(out_.mesh, faces);
  out_.original.places = std::move(frames_);
  out_.original.in_mesh.reserve(number_.size());
  for (const std::uint32_t number : number_) out_.original.in_mesh.push_back(number != no_number);
  return std::move(out_);
}

void FrameIntake::take_room(std::uint64_t vertices) {
  if (vertices >= no_number)
    throw Error(ErrorKind::bad_input, readers_.name(out_.frames) + " has " + grouped(vertices) +
                                          " vertices; a frame of a sequence has at most " +
                                          grouped(no_number - 1));
  const std::uint64_t bytes = IntakeMemory::arrays_for(vertices, carried_.count());
  if (bytes <= arrays_.bytes()) return;
  arrays_.release();
  if (bytes > memory_.arrays) (*refuse_)(vertices, bytes);
  arrays_ = job_.budget.try_reserve(bytes);
  if (!arrays_) (*refuse_)(vertices, bytes);
}

void FrameIntake::read_positions(MeshReader& reader) {
  if (!reader.facts().vertices) return read_corners(reader);
  const std::uint64_t vertices = *reader.facts().vertices;
  if (out_.frames == 0) {
    carried_.begin_first(reader, *settle_);
    take_room(vertices);
    carried_.begin_frame(vertices);
    position_.resize(vertices);
  } else if (vertices != position_.size()) {
    refuse_counts("vertices", vertices, position_.size());
  } else {
    carried_.begin_later(reader, readers_.name(out_.frames));
  }
  const bool first = out_.frames == 0;
  for_each_position_batch(job_, reader, [&](const PositionView& view) {
    for (std::size_t i = 0; i < view.count; ++i) {
      const std::uint64_t v = view.first + i;
      position_[first ? v : order_.place[v]] = {view.axis[0][i], view.axis[1][i], view.axis[2][i]};
    }
    carried_.take(reader, view, first ? nullptr : order_.place.data());
  });
}

void FrameIntake::read_corners(MeshReader& reader) {
  corners_ = true;
  const bool first = out_.frames == 0;
  std::uint64_t count = 0;
  std::vector<Point> points;
  for_each_face_batch_in_order(
      job_, reader,
      [&](const FaceBatch& batch, BatchBytes& bytes) {
        for (std::size_t f = 0; f < batch.count; ++f) {
          for (std::size_t c = 0; c < 3; ++c) append(bytes, Point(batch.corner(c, f)));
        }
      },
      [&](std::span<const std::byte> bytes) {
        points.resize(bytes.size() / sizeof(Point));
        std::memcpy(points.data(), bytes.data(), bytes.size());
        if (first) {
          if (count + points.size() > position_.capacity()) {
            const std::uint64_t more = (count + points.size()) / 4 * 5;
            take_room(std::max(more, 3 * reader.facts().faces.value_or(0)));
            position_.reserve(arrays_.bytes() / IntakeMemory::arrays_for(1, 0));
          }
          position_.insert(position_.end(), points.begin(), points.end());
        } else if (count + points.size() <= position_.size()) {
          for (std::size_t i = 0; i < points.size(); ++i)
            position_[order_.place[count + i]] = points[i];
        }
        count += points.size();
      });
  if (!first && count != position_.size()) refuse_counts("faces", count / 3, position_.size() / 3);
}

void FrameIntake::refuse_counts(const char* what, std::uint64_t here, std::uint64_t first) const {
  throw Error(ErrorKind::bad_input, readers_.name(out_.frames) + " has " + grouped(here) + " " +
                                        what + ", and " + readers_.name(0) + " has " +
                                        grouped(first) +
                                        "; all frames need the same vertices and faces");
}

void FrameIntake::read_faces(MeshReader& reader, Spool& into) {
  for_each_face_batch_in_order(
      job_, reader,
      [&](const FaceBatch& batch, BatchBytes& bytes) {
        for (std::size_t f = 0; f < batch.count; ++f)
          append(bytes, FaceVertices{batch.index[0][f], batch.index[1][f], batch.index[2][f]});
      },
      [&](std::span<const std::byte> bytes) { into.append(bytes); });
}

void FrameIntake::compare_faces(MeshReader& reader) {
  const std::uint64_t faces = record_count<FaceVertices>(raw_faces_);
  std::uint64_t count = 0;
  std::vector<FaceVertices> here;
  for_each_face_batch_in_order(
      job_, reader,
      [&](const FaceBatch& batch, BatchBytes& bytes) {
        for (std::size_t f = 0; f < batch.count; ++f)
          append(bytes, FaceVertices{batch.index[0][f], batch.index[1][f], batch.index[2][f]});
      },
      [&](std::span<const std::byte> bytes) {
        here.resize(bytes.size() / sizeof(FaceVertices));
        std::memcpy(here.data(), bytes.data(), bytes.size());
        const std::uint64_t both =
            std::min<std::uint64_t>(here.size(), faces - std::min(faces, count));
        const std::vector<FaceVertices> first =
            read_records<FaceVertices>(raw_faces_, std::min(faces, count), both);
        for (std::size_t f = 0; f < both; ++f) {
          if (here[f] == first[f]) continue;
          throw Error(ErrorKind::bad_input,
                      readers_.name(out_.frames) + " has other faces than " + readers_.name(0) +
                          ": face " + grouped(count + f) + " (from 0) has the vertices " +
                          corners_of(here[f]) + " instead of " + corners_of(first[f]) +
                          "; all frames need the same vertices and faces");
        }
        count += here.size();
      });
  if (count != faces) refuse_counts("triangles", count, faces);
}

void FrameIntake::add_first(MeshReader& reader) {
  const InputFacts& facts = reader.facts();
  out_.format = facts.format;
  const std::vector<Attribute>& offered = facts.offer.scalars;
  out_.normals = facts.normals ||
                 std::any_of(offered.begin(), offered.end(),
                             [](const Attribute& attribute) { return names_normal(attribute); });
  polygons_ = facts.polygons && facts.vertices.has_value();
  out_.dropped = facts.choice;
  read_positions(reader);
  out_.vertices = position_.size();
  if (corners_) {
    for (std::uint32_t v = 0; v < out_.vertices; v += 3) {
      const FaceVertices face{v, v + 1, v + 2};
      append_records<FaceVertices>(raw_faces_, std::span(&face, 1));
    }
  } else {
    read_faces(reader, raw_faces_);
  }
  raw_faces_.finish();
  out_.faces = record_count<FaceVertices>(raw_faces_);
  order_vertices();
  keep_frame();
}

void FrameIntake::add_later(MeshReader& reader) {
  if (reader.facts().vertices.has_value() == corners_)
    throw Error(ErrorKind::bad_input,
                readers_.name(out_.frames) + " and " + readers_.name(0) +
                    " differ in that one stores vertices and the other does not; all frames need "
                    "the same vertices and faces");
  read_positions(reader);
  if (!corners_) compare_faces(reader);
  keep_frame();
}

void FrameIntake::order_vertices() {
  order_ = order_by_place(job_, position_, path_);
  put_in_order(position_, order_);
  carried_.put_in_order(order_);
  std::fill(path_.begin(), path_.end(), 0);
  finite_.assign(position_.size(), 1);
}

void FrameIntake::keep_frame() {
  for (std::size_t i = 0; i < position_.size(); ++i) {
    for (const double x : position_[i]) path_[i] = mixed_hash(path_[i] ^ bits_of(x));
    finite_[i] &= static_cast<std::uint8_t>(finite(position_[i]));
  }
  append_records<Point>(*frames_, position_);
  carried_.keep_frame();
  job_.progress.advance(position_.size());
}

// Of vertices at one place in the first frame, those with the same path are one.
void FrameIntake::join_vertices() {
  const std::size_t count = path_.size();
  same_as_.resize(count);
  std::iota(same_as_.begin(), same_as_.end(), 0U);
  SpoolCursor<Point> first(job_, *frames_);
  Point position{};
  Point before{};
  std::vector<std::uint32_t> here;
  const auto join = [&] {
    std::stable_sort(here.begin(), here.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return path_[a] < path_[b]; });
    for (std::size_t i = 1; i < here.size(); ++i) {
      if (path_[here[i]] != path_[here[i - 1]]) continue;
      same_as_[here[i]] = same_as_[here[i - 1]];
      ++out_.joined;
    }
    here.clear();
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    first.next(position);
    if (i > 0 && position != before) join();
    here.push_back(i);
    before = position;
  }
  join();
}

void FrameIntake::number_used(const Spool& faces) {
  number_.assign(same_as_.size(), no_number);
  SpoolCursor<FaceVertices> cursor(job_, faces);
  std::uint64_t number = 0;
  for (FaceVertices face{}; cursor.next(face); ++number) {
    bool good = true;
    for (std::uint32_t& v : face) {
      good &= v < order_.place.size();
      if (v < order_.place.size()) v = same_as_[order_.place[v]];
    }
    good &= face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
    if (!good) {
      ++out_.bad_faces;
      continue;
    }
    for (const std::uint32_t v : face) number_[v] = 0;
  }
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < number_.size(); ++i) {
    if (number_[i] == no_number) continue;
    number_[i] = next++;
    if (finite_[i] != 0) continue;
    std::size_t frame = 0;
    while (finite(read_record<Point>(*frames_, frame * number_.size() + i))) ++frame;
    throw Error(ErrorKind::bad_input,
                readers_.name(frame) + ": vertex " + grouped(order_.input[i]) +
                    " (from 0) is not finite, and faces use it; every vertex needs a place in "
                    "every frame");
  }
}

void FrameIntake::write_vertices(StoredMesh& mesh) {
  const std::size_t count = number_.size();
  const std::size_t at_once =
      std::clamp<std::size_t>(bytes_at_once / mesh.layout.vertex_bytes(), 1, 4096);
  std::vector<IndexedVertex> vertices;
  std::vector<std::byte> states;
  std::vector<double> numbers;  // of each vertex those of each frame
  const std::size_t carried = out_.attributes.size();
  const std::size_t state = mesh.layout.state;
  for (std::size_t first = 0; first < count; first += at_once) {
    const std::size_t end = std::min(count, first + at_once);
    vertices.clear();
    states.clear();
    numbers.clear();
    for (std::size_t t = 0; t < out_.frames; ++t) {
      const std::vector<Point> part = read_records<Point>(*frames_, t * count + first, end - first);
      const std::vector<double> of_frame =
          carried > 0 ? carried_.read(t, first, end - first) : std::vector<double>();
      std::size_t used = 0;
      for (std::size_t i = first; i < end; ++i) {
        if (number_[i] == no_number) continue;
        if (t == 0) {
          IndexedVertex vertex;
          vertex.key = order_.key[i];
          vertex.position = part[i - first];
          vertices.push_back(vertex);
        } else {
          if (t == 1) states.resize(states.size() + state);
          std::memcpy(states.data() + used * state + (t - 1) * sizeof(Point), &part[i - first],
                      sizeof(Point));
        }
        if (t == 0) numbers.resize(numbers.size() + mesh.layout.attributes);
        std::copy_n(of_frame.begin() + static_cast<std::ptrdiff_t>((i - first) * carried), carried,
                    numbers.begin() +
                        static_cast<std::ptrdiff_t>(used * mesh.layout.attributes + t * carried));
        ++used;
      }
    }
    mesh.append_vertices(vertices, states, numbers);
    job_.progress.advance(end - first);
  }
  mesh.finish_vertices();
}

void FrameIntake::write_faces(StoredMesh& mesh, const Spool& faces) {
  order_.key = {};
  path_ = {};
  SortedRecords<OrderedFace> in_order(job_, memory_.sorting);
  SpoolCursor<FaceVertices> cursor(job_, faces);
  for (FaceVertices face{}; cursor.next(face);) {
    bool good = true;
    for (std::uint32_t& v : face) {
      good &= v < order_.place.size();
      v = good ? number_[same_as_[order_.place[v]]] : no_number;
    }
    if (!good || face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
    in_order.add({lowest_first(face)});
  }
  MergedCursor<OrderedFace> merged = in_order.merged();
  Appender<OrderedFace> append(job_, *mesh.faces);
  for (OrderedFace face{}; merged.next(face);) {
    append.add(face);
    ++mesh.face_count;
  }
  append.flush();
  mesh.finish_faces();
}

}  // namespace winnow
