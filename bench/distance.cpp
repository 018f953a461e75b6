// How far two meshes lie apart, and how sound the second one is:
//   bench_distance ORIGINAL SIMPLIFIED [--samples N] [--threads N]
// Distances are exact (point to nearest triangle, in double, through a tree of boxes) from samples spread
// evenly by area over one mesh, and from its vertices, to the other mesh: "forward" from the original to the
// simplified mesh, "backward" the other way. Mean and RMS are over the samples alone, so they are integrals
// over the surface; the maximum is over samples and vertices. The samples are the same in every run, and the
// result is the same for every number of threads.
#include "peers/driver.hpp"
#include "peers/mesh_file.hpp"

#include <atomic>
#include <numeric>
#include <thread>

namespace {

using Index = std::uint32_t;

struct Point {
  double x = 0, y = 0, z = 0;
  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Point operator*(double s, Point a) { return {s * a.x, s * a.y, s * a.z}; }
  friend auto operator<=>(const Point&, const Point&) = default;
};

double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Point low(Point a, Point b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Point high(Point a, Point b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

struct Box {
  Point lo{HUGE_VAL, HUGE_VAL, HUGE_VAL}, hi{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  void add(Point p) {
    lo = low(lo, p);
    hi = high(hi, p);
  }
  int longest_axis() const {
    const Point side = hi - lo;
    return side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
  }
  double squared_distance(Point p) const {
    const Point outside = high(high(lo - p, p - hi), {});
    return dot(outside, outside);
  }
};

using Face = std::array<Index, 3>;
using Triangle = std::array<Point, 3>;

struct Mesh {
  std::vector<Point> vertices;
  std::vector<Face> faces;
  std::uint64_t skipped_faces = 0;  // with a corner that is not finite
  Triangle triangle(const Face& f) const { return {vertices[f[0]], vertices[f[1]], vertices[f[2]]}; }
};

double area(const Triangle& t) {
  const Point normal = cross(t[1] - t[0], t[2] - t[0]);
  return std::sqrt(dot(normal, normal)) / 2;
}

// ---- Reading ----

// Makes one vertex of equal positions, in order of position. Only what faces use is kept, which is finite
// and can be ordered.
void weld(Mesh& mesh) {
  std::vector<Index> order, name(mesh.vertices.size());
  for (const Face& face : mesh.faces) order.insert(order.end(), face.begin(), face.end());
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return mesh.vertices[a] < mesh.vertices[b]; });
  std::vector<Point> distinct;
  for (const Index i : order) {
    if (distinct.empty() || distinct.back() != mesh.vertices[i]) distinct.push_back(mesh.vertices[i]);
    name[i] = static_cast<Index>(distinct.size() - 1);
  }
  for (Face& face : mesh.faces) {
    for (Index& i : face) i = name[i];
  }
  mesh.vertices = std::move(distinct);
}

Mesh read(const std::string& path) {
  const bench::MeshFile file(path);
  const bool is_ply = file.layout().is_ply;
  const auto numbers = is_ply ? file.read_vertices<double>() : file.read_corners<double>();
  Mesh mesh;
  mesh.vertices.resize(numbers.size() / 3);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    mesh.vertices[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
  bench::Array<Index> indices;
  if (is_ply) indices = file.read_indices();
  mesh.faces.reserve(file.layout().faces);
  const auto finite = [&](Index i) {
    const Point& p = mesh.vertices[i];
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  for (std::size_t i = 0; i < file.layout().faces; ++i) {
    const auto first = static_cast<Index>(3 * i);
    const Face face = is_ply ? Face{indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]}
                             : Face{first, first + 1, first + 2};
    if (finite(face[0]) && finite(face[1]) && finite(face[2])) {
      mesh.faces.push_back(face);
    } else {
      ++mesh.skipped_faces;
    }
  }
  if (!is_ply) weld(mesh);
  if (mesh.faces.empty()) throw std::runtime_error(path + " has no faces");
  return mesh;
}

std::vector<bool> referenced_vertices(const Mesh& mesh) {
  std::vector<bool> referenced(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    for (const Index i : face) referenced[i] = true;
  }
  return referenced;
}

Box box_of(const Mesh& mesh) {
  Box box;
  for (const Face& face : mesh.faces) {
    for (const Index i : face) box.add(mesh.vertices[i]);
  }
  return box;
}

// ---- Distance ----

double squared_distance_to_segment(Point p, Point a, Point b) {
  const Point along = b - a;
  const double length2 = dot(along, along);
  const double t = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  const Point gap = p - (a + t * along);
  return dot(gap, gap);
}

// The nearest point is the foot of the perpendicular if that lies inside, else it lies on an edge.
double squared_distance(Point p, const Triangle& t) {
  const Point ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const Point normal = cross(ab, ac);
  const double normal2 = dot(normal, normal);
  // In a needle thinner than this (squared sine of its angle) rounding decides where the normal points.
  if (normal2 > 1e-20 * dot(ab, ab) * dot(ac, ac)) {
    const double beyond_b = dot(cross(ap, ac), normal);
    const double beyond_c = dot(cross(ab, ap), normal);
    if (beyond_b >= 0 && beyond_c >= 0 && beyond_b + beyond_c <= normal2) {
      const double height = dot(ap, normal);
      return height * height / normal2;
    }
  }
  return std::min({squared_distance_to_segment(p, t[0], t[1]), squared_distance_to_segment(p, t[1], t[2]),
                   squared_distance_to_segment(p, t[2], t[0])});
}

// A binary tree of boxes over triangles, halved at the median of the centres along the longest axis. A node's
// children stand at `first` and `first + 1`; a leaf holds triangles [first, first + count).
class Tree {
 public:
  explicit Tree(const Mesh& mesh) {
    std::vector<Point> centres;
    for (const Face& face : mesh.faces) {
      const Triangle t = mesh.triangle(face);
      centres.push_back(0.5 * (low(t[0], low(t[1], t[2])) + high(t[0], high(t[1], t[2]))));
    }
    std::vector<Index> order(mesh.faces.size());
    std::iota(order.begin(), order.end(), 0);
    nodes_.push_back({.first = 0, .count = static_cast<Index>(order.size())});
    for (std::size_t i = 0; i < nodes_.size(); ++i) split(i, centres, order);
    for (const Index i : order) triangles_.push_back(mesh.triangle(mesh.faces[i]));
    fit_boxes();
  }

  // The nearest triangle's squared distance. `guess` is any triangle; points that follow each other on a
  // surface should pass the last answer on, since a good guess cuts most of the search.
  double squared_distance_from(Point p, Index& guess) const {
    double best = squared_distance(p, triangles_[guess]);
    struct Open {
      Index node;
      double bound;
    };
    Open stack[64];  // one entry a level, and the tree is balanced
    int open = 0;
    stack[open++] = {0, nodes_[0].box.squared_distance(p)};
    while (open > 0) {
      const Open next = stack[--open];
      if (next.bound >= best) continue;
      const Node& node = nodes_[next.node];
      if (node.count > 0) {
        for (Index i = node.first; i < node.first + node.count; ++i) {
          const double found = squared_distance(p, triangles_[i]);
          if (found >= best) continue;
          best = found;
          guess = i;
        }
        continue;
      }
      Open near{node.first, nodes_[node.first].box.squared_distance(p)};
      Open far{node.first + 1, nodes_[node.first + 1].box.squared_distance(p)};
      if (far.bound < near.bound) std::swap(near, far);
      if (far.bound < best) stack[open++] = far;
      if (near.bound < best) stack[open++] = near;
    }
    return best;
  }

 private:
  struct Node {
    Box box{};
    Index first = 0, count = 0;  // count 0: not a leaf
  };

  void split(std::size_t at, const std::vector<Point>& centres, std::vector<Index>& order) {
    constexpr Index kLeaf = 4;
    const auto [box, first, count] = nodes_[at];
    if (count <= kLeaf) return;
    Box span;
    for (Index i = first; i < first + count; ++i) span.add(centres[order[i]]);
    const int axis = span.longest_axis();
    const Index half = count / 2;
    const auto begin = order.begin() + first;
    std::nth_element(begin, begin + half, begin + count,
                     [&](Index a, Index b) { return centres[a][axis] < centres[b][axis]; });
    nodes_[at].count = 0;
    nodes_[at].first = static_cast<Index>(nodes_.size());
    nodes_.push_back({.first = first, .count = half});
    nodes_.push_back({.first = first + half, .count = count - half});
  }

  void fit_boxes() {
    for (std::size_t i = nodes_.size(); i-- > 0;) {  // children stand behind their parents
      Node& node = nodes_[i];
      if (node.count == 0) {
        node.box = nodes_[node.first].box;
        node.box.add(nodes_[node.first + 1].box.lo);
        node.box.add(nodes_[node.first + 1].box.hi);
      }
      for (Index k = node.first; k < node.first + node.count; ++k) {
        for (const Point& corner : triangles_[k]) node.box.add(corner);
      }
    }
  }

  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
};

// Points at equal steps of area along the list of faces, each placed inside its face by a sequence that
// covers the square evenly (Roberts' R2: multiples of the plastic number's inverse powers).
std::vector<Point> area_samples(const Mesh& mesh, std::size_t count, double total_area) {
  std::vector<Point> samples;
  samples.reserve(count);
  double passed = 0;
  for (const Face& face : mesh.faces) {
    const Triangle t = mesh.triangle(face);
    passed += area(t);
    while (samples.size() < count &&
           (static_cast<double>(samples.size()) + 0.5) / static_cast<double>(count) * total_area < passed) {
      double whole = 0;
      const auto n = static_cast<double>(samples.size());
      double u = std::modf(0.5 + n * 0.7548776662466927, &whole);
      double v = std::modf(0.5 + n * 0.5698402909980532, &whole);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      samples.push_back(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
    }
  }
  return samples;
}

// Distances of all points. Threads take blocks as they come; every result has its place, so their order does
// not matter.
std::vector<double> distances(const std::vector<Point>& points, const Tree& tree, unsigned threads) {
  constexpr std::size_t kBlock = 4096;
  std::vector<double> result(points.size());
  std::atomic<std::size_t> next = 0;
  std::vector<std::thread> pool;
  for (unsigned i = 0; i < threads; ++i) {
    pool.emplace_back([&] {
      Index guess = 0;
      for (std::size_t at = 0; (at = next.fetch_add(kBlock)) < points.size();) {
        for (std::size_t k = at; k < std::min(at + kBlock, points.size()); ++k) {
          result[k] = std::sqrt(tree.squared_distance_from(points[k], guess));
        }
      }
    });
  }
  for (auto& thread : pool) thread.join();
  return result;
}

bench::Json measure(const Mesh& from, const Tree& to, std::size_t samples, double diagonal,
                    unsigned threads) {
  double total_area = 0;
  for (const Face& face : from.faces) total_area += area(from.triangle(face));
  std::vector<Point> points = area_samples(from, samples, total_area);
  const std::size_t sampled = points.size();
  const std::vector<bool> referenced = referenced_vertices(from);
  for (std::size_t i = 0; i < from.vertices.size(); ++i) {
    if (referenced[i]) points.push_back(from.vertices[i]);
  }
  const std::vector<double> found = distances(points, to, threads);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < sampled; ++i) {
    sum += found[i];
    squares += found[i] * found[i];
  }
  const double count = std::max<double>(1, static_cast<double>(sampled));
  const double mean = sum / count, rms = std::sqrt(squares / count);
  const double most = *std::max_element(found.begin(), found.end());
  return bench::Json()
      .add("samples", sampled)
      .add("vertices", points.size() - sampled)
      .add("mean", mean)
      .add("rms", rms)
      .add("max", most)
      .add("mean_percent", 100 * mean / diagonal)
      .add("rms_percent", 100 * rms / diagonal)
      .add("max_percent", 100 * most / diagonal);
}

// ---- Soundness ----

bench::Json soundness(const Mesh& mesh) {
  std::vector<Face> sorted;
  std::vector<std::uint64_t> edges;  // of faces with three different vertices
  std::uint64_t degenerate = 0, zero_area = 0, total = mesh.faces.size();
  for (Face face : mesh.faces) {
    zero_area += area(mesh.triangle(face)) == 0;
    std::sort(face.begin(), face.end());
    sorted.push_back(face);
    if (face[0] == face[1] || face[1] == face[2]) {
      ++degenerate;
      continue;
    }
    for (const auto& [a, b] : {std::pair{face[0], face[1]}, {face[1], face[2]}, {face[0], face[2]}}) {
      edges.push_back(std::uint64_t{a} << 32 | b);
    }
  }
  std::sort(sorted.begin(), sorted.end());
  const auto distinct =
      static_cast<std::uint64_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
  std::sort(edges.begin(), edges.end());
  std::uint64_t boundary = 0, crowded = 0;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    boundary += end - i == 1;
    crowded += end - i > 2;
  }
  const std::vector<bool> referenced = referenced_vertices(mesh);
  return bench::Json()
      .add("faces", total)
      .add("vertices", mesh.vertices.size())
      .add("skipped_faces", mesh.skipped_faces)
      .add("duplicate_faces", total - distinct)
      .add("degenerate_faces", degenerate)
      .add("zero_area_faces", zero_area)
      .add("unreferenced_vertices", std::count(referenced.begin(), referenced.end(), false))
      .add("nonmanifold_edges", crowded)
      .add("boundary_edges", boundary);
}

void run(const bench::Arguments& arguments) {
  if (arguments.files().size() != 2) throw std::runtime_error("usage: ORIGINAL SIMPLIFIED [--samples N]");
  const auto samples = static_cast<std::size_t>(arguments.number("--samples", 1e6));
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const auto threads = static_cast<unsigned>(arguments.number("--threads", cores));

  Mesh original = read(arguments.files()[0]), simplified = read(arguments.files()[1]);
  const Box box = box_of(original);
  const double diagonal = std::sqrt(dot(box.hi - box.lo, box.hi - box.lo));
  for (Mesh* mesh : {&original, &simplified}) {
    for (Point& vertex : mesh->vertices) vertex = vertex - box.lo;  // keeps digits of faraway scans
  }
  bench::Json json;
  json.add("original", bench::Json()
                           .add("faces", original.faces.size())
                           .add("vertices", original.vertices.size())
                           .add("skipped_faces", original.skipped_faces)
                           .add("diagonal", diagonal));
  json.add("simplified", soundness(simplified));
  json.add("forward", measure(original, Tree(simplified), samples, diagonal, threads));
  json.add("backward", measure(simplified, Tree(original), samples, diagonal, threads));
  json.print();
}

}  // namespace

int main(int argc, char** argv) {
  return bench::guarded("bench_distance", [&] {
    run(bench::Arguments(argc, argv, {}, {"--samples", "--threads"}));
  });
}
