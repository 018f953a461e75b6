#include "decimate/unfold.hpp"

#include "base/rounding.hpp"
#include "base/sort_unique.hpp"
#include "decimate/surroundings.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace winnow {

namespace {

// A face is suspicious if the cosine between its normal and that of a corner is below this. A
// corner's normal is the mean of its faces' normals, weighted by area. Of a scan at 1 %, one face
// in twelve is suspicious, and of the flipped faces 83 in 85.
constexpr double suspicious_cosine = 0.2;
// How far corners may move, as a part of the face's longest side.
constexpr double reach = 0.5;
// The mean error is that of faces that lie askew, which is some times that of all faces. With 3 all
// faces of a horse at 20 % turn over, with 1 some stay.
constexpr double error_of_askew_faces = 4;
// A moved vertex gives faces around it another chance.
constexpr unsigned rounds = 3;
// A vertex with more faces stays, because every move takes a look at all of them.
constexpr std::size_t most_faces = 32;
// How far the reference is known around a face, as a part of its longest side, and around all faces
// at its corners. Around a middle, mostly the first margin is enough.
constexpr double face_margin = 0.35;
constexpr std::array<double, 2> middle_margins{0.05, face_margin};
constexpr double ring_margin = 0.2;

// Some corners of a face, moved by the same vector.
struct Move {
  unsigned corners = 0;  // bit i: corner i
  Point by{};
  double size = 0;  // the sum of the lengths

  [[nodiscard]] bool has_corner(unsigned i) const { return (corners >> i & 1) != 0; }
};

// A face at a corner of the face that is to be turned over, as it is before.
struct Beside {
  FaceNumber number;
  Triangle corner;
  Hints hints = no_hints;
  // What is known of it when it is needed.
  bool seen = false;
  bool flipped = false;
  std::optional<double> error{};
};

struct Neighbourhood {
  Surroundings around;
  std::vector<Beside> faces;
};

class Unfolder {
 public:
  Unfolder(std::vector<Point>& positions, std::span<const FaceVertices> faces,
           std::span<const std::uint8_t> locked, const UnfoldRules& rules,
           ReferenceSurface& reference)
      : position_(positions), face_(faces), locked_(locked), rules_(rules), reference_(reference) {}

  Unfolded run() {
    list_faces();
    find_suspects();
    for (unsigned round = 0; round < rounds && !left_.empty(); ++round) {
      const std::size_t moved = done_.moved.size();
      for (const FaceNumber f : std::exchange(left_, {})) turn_over(f);
      keep_those_near(std::span(done_.moved).subspan(moved));
    }
    std::sort(done_.moved.begin(), done_.moved.end());
    done_.moved.erase(std::unique(done_.moved.begin(), done_.moved.end()), done_.moved.end());
    return std::move(done_);
  }

 private:
  [[nodiscard]] Triangle triangle(FaceNumber f) const {
    return {position_[face_[f][0]], position_[face_[f][1]], position_[face_[f][2]]};
  }

  // Sets the suspicious faces whose middles are opposed, of those that can change, and the mean
  // error of suspicious faces.
  void find_suspects() {
    std::vector<Point> normals(position_.size(), Point{});
    double area = 0;
    for (FaceNumber f = 0; f < face_.size(); ++f) {
      const Point normal = doubled_area(triangle(f));
      area += length(normal) / 2;
      for (const VertexNumber v : face_[f]) normals[v] = normals[v] + normal;
    }
    double squares = 0;
    std::uint64_t known = 0;
    for (FaceNumber f = 0; f < face_.size(); ++f) {
      if (!rules_.thorough && !suspicious(f, normals)) continue;
      if (std::none_of(face_[f].begin(), face_[f].end(),
                       [&](VertexNumber v) { return can_move(v); }))
        continue;
      const Triangle t = triangle(f);
      Box middle;
      middle.add(middle_of(t));
      for (const double margin : middle_margins) {
        const Surroundings around(reference_, middle, margin * box_around(t).longest_side());
        SurfacePatch::Hint hint = SurfacePatch::unknown;
        const auto squared = around.squared_distance(middle.low, hint);
        if (!squared) continue;
        squares += *squared;
        ++known;
        if (around.patch().opposed(middle.low, doubled_area(t), hint)) left_.push_back(f);
        break;
      }
    }
    if (known > 0)
      usual_error_ =
          squares / static_cast<double>(known) * area / static_cast<double>(face_.size());
    if (rules_.thorough) usual_error_ *= error_of_askew_faces;
  }

  [[nodiscard]] bool suspicious(FaceNumber f, const std::vector<Point>& normals) const {
    const Point normal = doubled_area(triangle(f));
    const double size = length(normal);
    return std::any_of(face_[f].begin(), face_[f].end(), [&](VertexNumber v) {
      return dot(normal, normals[v]) < suspicious_cosine * size * length(normals[v]);
    });
  }

  void list_faces() {
    first_.assign(position_.size() + 1, 0);
    for (const FaceVertices& face : face_) {
      for (const VertexNumber v : face) ++first_[v + 1];
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    listed_.resize(3 * face_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (FaceNumber f = 0; f < face_.size(); ++f) {
      for (const VertexNumber v : face_[f]) listed_[next[v]++] = f;
    }
  }

  [[nodiscard]] std::span<const FaceNumber> faces_of(VertexNumber v) const {
    return std::span(listed_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

  // Whether no edge of the vertex has more than two faces or, as the rules say, less, and nothing
  // else holds it.
  [[nodiscard]] bool can_move(VertexNumber v) const {
    if (locked_[v] != 0 || faces_of(v).size() > most_faces) return false;
    std::vector<VertexNumber> met;
    for (const FaceNumber f : faces_of(v)) {
      for (const VertexNumber w : face_[f]) {
        if (w != v) met.push_back(w);
      }
    }
    std::sort(met.begin(), met.end());
    for (std::size_t first = 0, next = 0; first < met.size(); first = next) {
      while (next < met.size() && met[next] == met[first]) ++next;
      if (next - first > 2 || (next - first == 1 && !rules_.thorough)) return false;
    }
    return true;
  }

  // Moves corners of the face if it is flipped. If it stays so, it goes to left_.
  void turn_over(FaceNumber f) {
    unsigned free = 0;
    for (unsigned i = 0; i < 3; ++i) free |= can_move(face_[f][i]) ? 1U << i : 0;
    if (free == 0) return;
    const Triangle from = triangle(f);
    const Box box = box_around(from);
    const Surroundings around(reference_, box, face_margin * box.longest_side());
    Hints hints = no_hints;
    if (!around.error(from, hints) || !around.flipped(from, hints)) return;
    std::optional<Neighbourhood> ring;
    for (const Move& move : moves_of(from, free, around.patch())) {
      ++done_.tried;
      if (around.flipped(place(f, from, move), hints)) continue;
      if (!ring) {
        place(f, from, {});
        ring = look_around(f, free);
        place(f, from, move);
      }
      if (better(*ring, f, move)) return;
    }
    place(f, from, {});
    left_.push_back(f);
  }

  // Moves that bring an inner point to a part of the reference that faces the same way, or past it,
  // and moves of a corner to the other side of the opposite edge; the smallest first. `free`:
  // corners that can move.
  static std::vector<Move> moves_of(const Triangle& t, unsigned free, const SurfacePatch& patch) {
    const double far = reach * box_around(t).longest_side();
    std::vector<Move> moves;
    const auto add = [&](unsigned corners, const Point& by) {
      const double size = length(by);
      if (size <= far) moves.push_back({corners, by, size * std::popcount(corners)});
    };
    const Point normal = doubled_area(t);
    const std::array<Point, 4> points = inner_points(t);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto way = patch.way_to_facing(points[i], normal);
      if (!way) continue;
      for (unsigned corners = 1; corners < 8; ++corners) {
        if ((corners & ~free) != 0) continue;
        double weight = 0;
        for (unsigned c = 0; c < 3; ++c) weight += (corners >> c & 1) * weight_of(c, i);
        for (const double part : {0.6, 1.0, 1.4}) add(corners, part / weight * *way);
      }
    }
    for (unsigned c = 0; c < 3; ++c) {
      if ((free >> c & 1) == 0) continue;
      const Point& start = t[(c + 1) % 3];
      const Point edge = t[(c + 2) % 3] - start;
      const Point off = t[c] - start;
      const Point height = off - dot(off, edge) / dot(edge, edge) * edge;
      for (const double part : {1.1, 1.3, 1.6, 2.0}) add(1U << c, -part * height);
    }
    std::stable_sort(moves.begin(), moves.end(),
                     [](const Move& a, const Move& b) { return a.size < b.size; });
    return moves;
  }

  // Puts the corners where the move takes them from `from`.
  Triangle place(FaceNumber f, const Triangle& from, const Move& move) {
    for (unsigned i = 0; i < 3; ++i) {
      Point& to = position_[face_[f][i]];
      to = from[i];
      if (!move.has_corner(i)) continue;
      to = to + move.by;
      if (rules_.single) {
        for (double& x : to) x = nearest_float(x);
      }
    }
    return triangle(f);
  }

  [[nodiscard]] Neighbourhood look_around(FaceNumber f, unsigned free) const {
    std::vector<FaceNumber> numbers;
    for (unsigned i = 0; i < 3; ++i) {
      if ((free >> i & 1) == 0) continue;
      const std::span<const FaceNumber> faces = faces_of(face_[f][i]);
      numbers.insert(numbers.end(), faces.begin(), faces.end());
    }
    sort_unique(numbers);
    Box box;
    std::vector<Beside> faces;
    for (const FaceNumber number : numbers) {
      faces.push_back({number, triangle(number)});
      box.add(box_around(faces.back().corner));
    }
    return {Surroundings(reference_, box, ring_margin * box.longest_side()), std::move(faces)};
  }

  static void look_at(Beside& face, const Surroundings& around) {
    if (face.seen) return;
    face.seen = true;
    face.error = around.error(face.corner, face.hints);
    face.flipped = face.error && around.flipped(face.corner, face.hints);
  }

  // Whether the move, which has been made, turns `f` over, leaves fewer faces flipped, and takes
  // the surface hardly farther from the reference. Then it counts.
  bool better(Neighbourhood& ring, FaceNumber f, const Move& move) {
    std::vector<Beside*> changed;
    std::size_t flipped = 0;
    double error = 0;
    for (Beside& face : ring.faces) {
      bool changes = false;
      for (unsigned i = 0; i < 3; ++i)
        changes |= move.has_corner(i) && has(face_[face.number], face_[f][i]);
      if (!changes) continue;
      look_at(face, ring.around);
      if (!face.error) return false;
      changed.push_back(&face);
      flipped += face.flipped ? 1 : 0;
      error += *face.error;
    }
    std::vector<FaceNumber> still;
    for (Beside* face : changed) {
      const Triangle t = triangle(face->number);
      if (is_line(t, coordinate_rounding(rules_.single))) return false;
      if (!ring.around.flipped(t, face->hints)) continue;
      still.push_back(face->number);
      if (face->number == f || still.size() >= flipped) return false;
    }
    if (flipped == 0) return false;
    error += static_cast<double>(flipped - still.size()) * usual_error_;
    for (Beside* face : changed) {
      const auto now = ring.around.error(triangle(face->number), face->hints);
      if (!now || *now > error) return false;
      error -= *now;
    }
    for (unsigned i = 0; i < 3; ++i) {
      if (move.has_corner(i)) done_.moved.push_back(face_[f][i]);
    }
    left_.insert(left_.end(), still.begin(), still.end());
    return true;
  }

  // Keeps the faces in left_ that share a vertex with a face that has changed.
  void keep_those_near(std::span<const VertexNumber> moved) {
    std::vector<VertexNumber> near;
    for (const VertexNumber v : moved) {
      for (const FaceNumber f : faces_of(v))
        near.insert(near.end(), face_[f].begin(), face_[f].end());
    }
    std::sort(near.begin(), near.end());
    std::sort(left_.begin(), left_.end());
    left_.erase(std::unique(left_.begin(), left_.end()), left_.end());
    std::erase_if(left_, [&](FaceNumber f) {
      return std::none_of(face_[f].begin(), face_[f].end(), [&](VertexNumber v) {
        return std::binary_search(near.begin(), near.end(), v);
      });
    });
  }

  std::vector<Point>& position_;
  std::span<const FaceVertices> face_;
  std::span<const std::uint8_t> locked_;
  UnfoldRules rules_;
  ReferenceSurface& reference_;
  Unfolded done_;
  std::vector<FaceNumber> left_;  // may be flipped
  double usual_error_ = 0;
  std::vector<std::uint32_t> first_;  // of each vertex the place of its first face in listed_
  std::vector<FaceNumber> listed_;
};

}  // namespace

Unfolded unfold(std::vector<Point>& positions, std::span<const FaceVertices> faces,
                std::span<const std::uint8_t> locked, const UnfoldRules& rules,
                ReferenceSurface& reference) {
  return Unfolder(positions, faces, locked, rules, reference).run();
}

std::uint64_t unfold_memory(std::uint64_t vertices, std::uint64_t faces, std::uint64_t near) {
  // The reference around a face and around its corners, and a list on its way.
  const std::uint64_t patches = near * (2 * SurfacePatch::bytes_a_face + sizeof(Triangle));
  return vertices * (sizeof(Point) + 2 * sizeof(std::uint32_t)) + 3 * faces * sizeof(FaceNumber) +
         patches;
}

}  // namespace winnow
