// The faces of a result, asked which of them is nearest to each of some points.
#pragma once

#include "fit/box_tree.hpp"
#include "fit/kernel/near_kernel.hpp"
#include "io/job.hpp"
#include "mesh/stored_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace winnow {

// As kernels take it, with lengths times `scale`.
FlatFace flat_face(const Triangle& t, double scale);

// Faces come in the order of their vertices' keys, so those that follow each other are close. So
// many of them are a page, with a tree of their boxes; the boxes of all pages are a tree as well.
// All pages are in memory, and large, or each thread has the few that it used last.
class FaceIndex {
 public:
  // `mesh` must stay. Uses at most `memory`, or what a few pages a thread need. Inside the job's
  // arena.
  FaceIndex(Job& job, const StoredMesh& mesh, std::uint64_t memory);

  // Whether points may be asked for in any order; else those that follow each other should be near.
  [[nodiscard]] bool in_memory() const { return !resident_.empty(); }
  [[nodiscard]] std::size_t pages() const { return boxes_.size(); }
  [[nodiscard]] double area() const { return area_; }
  // The page whose box is nearest, or one that is.
  [[nodiscard]] std::size_t page_near(const Point& point) const;

  struct Nearest {
    std::uint64_t face = 0;
    Triangle corner{};
    Point place{};  // on it
    double squared = 0;
  };

 private:
  struct Page {
    std::vector<Triangle> faces;
    std::vector<FlatFace> flat;
    std::optional<BoxTree> tree;
    double area = 0;
  };

 public:
  // For one thread.
  class Reader {
   public:
    explicit Reader(const FaceIndex& index);
    // Of each point; of several faces that are as near the one with the lowest number. Infinitely
    // far off where more than most_boxes() faces have boxes that are as near as the nearest face:
    // then faces lie across each other. Quick where points that follow each other are close.
    void nearest(std::span<const Point> points, std::vector<Nearest>& out);
    static std::size_t most_boxes();

   private:
    struct Candidate {
      std::uint64_t face;
      Triangle corner;
    };
    struct NearBox {
      double squared;
      Candidate face;

      bool operator<(const NearBox& other) const { return squared < other.squared; }
    };
    // Of all points at once. False where they are far apart or lie among many faces.
    bool look_around(std::span<const Point> points, std::vector<Nearest>& out);
    const Nearest& nearest_candidate(const Point& point);
    const Nearest& nearest(const Point& point);
    // Whether so few boxes are as near as the nearest face, which then is left in last_.
    bool look_into_nearest_boxes(const Point& point);
    // Leaves the face in last_ if it is nearer to the point.
    void take_nearer(const Point& point, std::uint64_t face, const Triangle& corner);
    struct Slot {
      std::size_t number = SIZE_MAX;
      std::uint64_t used = 0;
      Page page;
    };
    const Page& page(std::size_t number);

    const FaceIndex& index_;
    VertexIndex::Reader vertices_;
    std::vector<Slot> slots_;
    std::uint64_t turn_ = 0;
    Nearest last_;
    std::size_t at_once_ = PointGroup::capacity;
    double margin_ = 0;  // around points in which their nearest faces are expected
    PointGroup group_;
    std::vector<Candidate> candidates_;
    std::vector<FaceBeside> beside_;  // the same
    std::vector<NearBox> boxes_;      // a heap, the farthest first
  };

 private:
  static constexpr std::uint64_t page_bytes(std::uint64_t faces);
  static constexpr std::uint64_t making_bytes(std::uint64_t faces);
  [[nodiscard]] double usual_scale() const;
  void load(std::size_t number, VertexIndex::Reader& vertices, Page& page) const;

  Job& job_;
  const StoredMesh& mesh_;
  std::uint64_t page_faces_ = 0;
  Reservation reserved_;
  std::size_t slots_a_thread_ = 0;
  std::vector<Page> resident_;
  std::vector<Box> boxes_;  // of pages
  std::optional<BoxTree> tree_;
  double area_ = 0;
  double scale_ = 1;  // a power of two; times this, faces are about as long as 1
  NearKernel kernel_;
};

}  // namespace winnow
