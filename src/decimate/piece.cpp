#include "decimate/piece.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace winnow {

namespace {

using PieceEdge = std::pair<VertexNumber, VertexNumber>;

// All edges of all faces, the lower end first, in ascending order.
std::vector<PieceEdge> edges_of(const TileMesh& mesh, const Piece& piece) {
  std::vector<PieceEdge> edges;
  for (const FaceNumber f : piece.faces) {
    const FaceVertices& face = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(std::minmax(face[i], face[(i + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// each(edge, faces at it).
template <typename Each>
void for_each_edge(const std::vector<PieceEdge>& edges, const Each& each) {
  for (auto first = edges.begin(); first != edges.end();) {
    const auto end = std::upper_bound(first, edges.end(), *first);
    each(*first, static_cast<std::size_t>(end - first));
    first = end;
  }
}

// Of area 1 and length 1.
double mean_square(const Triangle& t) {
  const Point sum = t[0] + t[1] + t[2];
  return (dot(t[0], t[0]) + dot(t[1], t[1]) + dot(t[2], t[2]) + dot(sum, sum)) / 12;
}
double mean_square(const Point& a, const Point& b) {
  return (dot(a, a) + dot(b, b) + dot(a, b)) / 3;
}

}  // namespace

PieceLoss loss_of(const TileMesh& mesh, const Piece& piece, const VertexPlaces& places) {
  const Point& origin = places[piece.vertices.front()];
  PieceLoss loss;
  Point middle{};
  Point mean{};
  for (const FaceNumber f : piece.faces) {
    const Triangle t = places.triangle(mesh.face(f));
    const double area = length(doubled_area(t)) / 2;
    const Point third = (1.0 / 3) * ((t[0] - origin) + (t[1] - origin) + (t[2] - origin));
    loss.area += area;
    middle = middle + area * third;
    mean = mean + third;
  }
  middle = loss.area > 0 ? (1 / loss.area) * middle
                         : (1 / static_cast<double>(piece.faces.size())) * mean;
  middle = middle + origin;
  for (const FaceNumber f : piece.faces) {
    const Triangle t = places.triangle(mesh.face(f));
    loss.surface +=
        length(doubled_area(t)) / 2 * mean_square({t[0] - middle, t[1] - middle, t[2] - middle});
  }
  for (const VertexNumber v : piece.vertices) {
    const Point away = places[v] - middle;
    loss.farthest = std::max(loss.farthest, dot(away, away));
  }
  for_each_edge(edges_of(mesh, piece), [&](const PieceEdge& edge, std::size_t faces) {
    if (faces != 1) return;
    const Point a = places[edge.first] - middle;
    const Point b = places[edge.second] - middle;
    loss.boundary += dot(b - a, b - a) * mean_square(a, b);
  });
  return loss;
}

std::uint64_t handles_of(const TileMesh& mesh, const Piece& piece) {
  std::size_t edges = 0;
  bool surface = true;
  // Of each vertex the lowest known of its boundary loop.
  std::vector<VertexNumber> loop(piece.vertices);
  std::sort(loop.begin(), loop.end());
  const std::vector<VertexNumber> vertices = loop;
  const auto place = [&](VertexNumber v) {
    return static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                                    vertices.begin());
  };
  std::vector<std::size_t> open(vertices.size(), 0);
  std::vector<PieceEdge> boundary;
  for_each_edge(edges_of(mesh, piece), [&](const PieceEdge& edge, std::size_t faces) {
    ++edges;
    surface &= faces <= 2;
    if (faces != 1) return;
    boundary.push_back(edge);
    ++open[place(edge.first)];
    ++open[place(edge.second)];
  });
  for (const std::size_t at_vertex : open) surface &= at_vertex == 0 || at_vertex == 2;
  if (!surface) return 0;
  std::size_t loops = boundary.size();
  for (const auto& [a, b] : boundary) {
    const VertexNumber kept = std::min(loop[place(a)], loop[place(b)]);
    const VertexNumber gone = std::max(loop[place(a)], loop[place(b)]);
    if (kept != gone) --loops;
    std::replace(loop.begin(), loop.end(), gone, kept);
  }
  // A loop has as many edges as vertices, so one edge of each joined nothing.
  const auto euler = static_cast<std::int64_t>(piece.vertices.size()) -
                     static_cast<std::int64_t>(edges) +
                     static_cast<std::int64_t>(piece.faces.size());
  const std::int64_t doubled = 2 - euler - static_cast<std::int64_t>(loops);
  return doubled > 0 ? static_cast<std::uint64_t>(doubled / 2) : 0;
}

}  // namespace winnow
