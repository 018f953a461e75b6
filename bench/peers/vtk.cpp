// VTK's quadric clustering as a whole program from file to file:
//   peer_vtk IN OUT --faces N|--ratio R|--divisions N [--stream] [--merge]
// Cells are cubes, N of them along the longest side. With --faces that N is found by trial (see
// find_cells) outside the reported times, and reported, so that a timed run can be given
// --divisions.
//
// VTK's own readers and writer are used. STL is read as the soup it is, which the clustering does
// not mind;
// --merge lets the reader weld it first, its default, which is several times slower. --stream feeds
// the filter in pieces (StartAppend, Append, EndAppend) through our reader, since VTK's read whole
// files.
#include "peers/driver.hpp"
#include "peers/mesh_file.hpp"

#include <numeric>

#include <sys/sysinfo.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>

namespace {

using Box = std::array<double, 6>;  // as VTK orders it: x low, x high, y low, ...

// VTK 9.1 leaves to its pipeline what the append calls need too: the divisions in use, the size of
// a slice of the grid, an input to ask for lone vertices, and an output. Without these it crashes.
class StreamedClustering : public vtkQuadricClustering {
 public:
  static StreamedClustering* New() { VTK_STANDARD_NEW_BODY(StreamedClustering); }

  void start(Box box) {
    vtkNew<vtkPolyData> nothing;
    SetInputData(nothing);
    Update();
    std::copy_n(vtkQuadricClustering::GetNumberOfDivisions(), 3, NumberOfDivisions);
    SliceSize = vtkIdType{NumberOfDivisions[0]} * NumberOfDivisions[1];
    StartAppend(box.data());
  }
};

void set_divisions(vtkQuadricClustering* filter, const Box& box, double cells) {
  // The filter keeps one record for every cell of the box, occupied or not.
  constexpr double kCellBytes = 88;
  const double side = std::max({box[1] - box[0], box[3] - box[2], box[5] - box[4]});
  std::array<int, 3> divisions{};
  double bytes = kCellBytes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double part = (box[2 * axis + 1] - box[2 * axis]) / side;
    divisions[axis] = std::max(1, static_cast<int>(std::lround(cells * part)));
    bytes *= divisions[axis];
  }
  struct sysinfo machine {};
  ::sysinfo(&machine);
  if (bytes > 0.9 * double(machine.totalram) * machine.mem_unit) {
    throw std::runtime_error("the filter's grid alone needs " + std::to_string(bytes / 1e9) +
                             " GB");
  }
  filter->SetNumberOfDivisions(divisions.data());
  filter->AutoAdjustNumberOfDivisionsOff();
}

struct Result {
  bench::Report report;
  double cells = 0, seconds_search = 0;
};

Result simplify_whole(const bench::Arguments& arguments, vtkQuadricClustering* filter) {
  Result result;
  bench::Stopwatch watch;
  vtkNew<vtkPLYReader> ply;
  vtkNew<vtkSTLReader> stl;
  const std::string path = arguments.files()[0];
  const bool is_ply = bench::MeshFile(path).layout().is_ply;
  ply->SetFileName(path.c_str());
  stl->SetFileName(path.c_str());
  stl->SetMerging(arguments.has("--merge"));
  vtkPolyDataAlgorithm* reader = ply;
  if (!is_ply) reader = stl;
  reader->Update();
  const vtkSmartPointer<vtkPolyData> mesh = reader->GetOutput();
  result.report.faces_in = static_cast<std::uint64_t>(mesh->GetNumberOfPolys());
  result.report.read = watch.lap();

  Box box{};
  mesh->GetBounds(box.data());
  filter->SetInputData(mesh);
  const auto cluster = [&](double cells) {
    set_divisions(filter, box, cells);
    filter->Update();
    return filter->GetOutput()->GetNumberOfPolys();
  };
  result.cells = arguments.number("--divisions", 0);
  if (result.cells == 0) {
    const auto target = static_cast<double>(arguments.target_faces(result.report.faces_in));
    result.cells =
        std::round(bench::find_cells(target, [&](double n) { return cluster(std::round(n)); }));
  }
  result.seconds_search = watch.lap();

  filter->Modified();  // the last trial may have been this very one
  cluster(result.cells);
  result.report.simplify = watch.lap();
  return result;
}

// A piece of the mesh as soup: the corners of some faces, three new points each.
class Piece {
 public:
  Piece() { points_->SetNumberOfComponents(3); }
  void add(const float* xyz) { points_->InsertNextTypedTuple(xyz); }
  bool empty() const { return points_->GetNumberOfTuples() == 0; }
  bool full() const { return points_->GetNumberOfTuples() >= 3 << 18; }

  void give(vtkQuadricClustering* filter) {
    vtkNew<vtkTypeInt32Array> corners, offsets;
    corners->SetNumberOfValues(points_->GetNumberOfTuples());
    offsets->SetNumberOfValues(points_->GetNumberOfTuples() / 3 + 1);
    std::iota(corners->Begin(), corners->End(), 0);
    std::generate(offsets->Begin(), offsets->End(), [next = -3]() mutable { return next += 3; });
    vtkNew<vtkCellArray> faces;
    faces->SetData(offsets, corners);
    vtkNew<vtkPoints> points;
    points->SetData(points_);
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(faces);
    filter->Append(mesh);
    points_->Reset();
  }

 private:
  vtkNew<vtkFloatArray> points_;
};

void extend(Box& box, const float* xyz) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box[2 * axis] = std::min(box[2 * axis], double(xyz[axis]));
    box[2 * axis + 1] = std::max(box[2 * axis + 1], double(xyz[axis]));
  }
}

Result simplify_streamed(const bench::Arguments& arguments, StreamedClustering* filter) {
  Result result;
  result.cells = arguments.number("--divisions", 0);
  if (result.cells == 0) throw std::runtime_error("--stream needs --divisions");
  bench::Stopwatch watch;
  const bench::MeshFile file(arguments.files()[0]);
  const bench::Layout& layout = file.layout();
  result.report.faces_in = layout.faces;

  // The box must be known first: from the vertices of a PLY file, which stay in memory for the
  // look-ups, or from a pass over the corners of an STL file.
  Box box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  bench::Array<float> vertices;
  if (layout.is_ply) {
    vertices = file.read_vertices<float>();
    for (std::size_t i = 0; i < vertices.size(); i += 3) extend(box, vertices.data() + i);
  } else {
    file.for_each_record(
        layout.faces_at, layout.faces, layout.face_stride, [&](const unsigned char* face) {
          const auto corners = bench::load<std::array<float, 9>>(face + layout.corners_at);
          for (std::size_t i = 0; i < 9; i += 3) extend(box, &corners[i]);
        });
  }
  set_divisions(filter, box, result.cells);
  filter->start(box);
  result.report.read = watch.lap();

  Piece piece;
  const auto flush = [&] {
    result.report.read += watch.lap();
    piece.give(filter);
    result.report.simplify += watch.lap();
  };
  file.for_each_record(
      layout.faces_at, layout.faces, layout.face_stride, [&](const unsigned char* face) {
        if (layout.is_ply) {
          for (const auto i : bench::load<std::array<std::uint32_t, 3>>(face + layout.indices_at)) {
            if (i >= layout.vertices)
              throw std::runtime_error("a face names a vertex that is not there");
            piece.add(vertices.data() + 3 * std::size_t{i});
          }
        } else {
          const auto corners = bench::load<std::array<float, 9>>(face + layout.corners_at);
          for (std::size_t i = 0; i < 9; i += 3) piece.add(&corners[i]);
        }
        if (piece.full()) flush();
      });
  if (!piece.empty()) flush();
  filter->EndAppend();
  result.report.simplify += watch.lap();
  return result;
}

void run(const bench::Arguments& arguments) {
  if (arguments.files().size() != 2) throw std::runtime_error("usage: IN OUT --faces N");
  vtkNew<StreamedClustering> filter;  // a plain one, unless start() is called
  Result result = arguments.has("--stream") ? simplify_streamed(arguments, filter)
                                            : simplify_whole(arguments, filter);
  bench::Report& report = result.report;
  report.faces_out = static_cast<std::uint64_t>(filter->GetOutput()->GetNumberOfPolys());

  bench::Stopwatch watch;
  vtkNew<vtkPLYWriter> writer;
  writer->SetFileName(arguments.files()[1].c_str());
  writer->SetFileTypeToBinary();
  writer->SetDataByteOrderToLittleEndian();
  writer->SetInputData(filter->GetOutput());
  if (writer->Write() == 0) throw std::runtime_error("cannot write");
  report.write = watch.lap();
  report.json().add("divisions", result.cells).add("seconds_search", result.seconds_search).print();
}

}  // namespace

int main(int argc, char** argv) {
  return bench::guarded("peer_vtk", [&] {
    run(bench::Arguments(argc, argv, {"--stream", "--merge"},
                         {"--faces", "--ratio", "--divisions"}));
  });
}
