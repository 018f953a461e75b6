// VTK's quadric decimation (edge collapse) as a whole program from file to file, one thread:
//   peer_vtk_decimate IN OUT --faces N|--ratio R
// VTK's own readers and writer; its STL reader welds, as the collapse needs a connected mesh.
#include "peers/driver.hpp"
#include "peers/mesh_file.hpp"

#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSTLReader.h>

namespace {

void run(const bench::Arguments& arguments) {
  if (arguments.files().size() != 2) throw std::runtime_error("usage: IN OUT --faces N");
  const std::string path = arguments.files()[0];
  bench::Report report;
  bench::Stopwatch watch;
  vtkNew<vtkPLYReader> ply;
  vtkNew<vtkSTLReader> stl;
  ply->SetFileName(path.c_str());
  stl->SetFileName(path.c_str());
  vtkPolyDataAlgorithm* reader = ply;
  if (!bench::MeshFile(path).layout().is_ply) reader = stl;
  reader->Update();
  report.faces_in = static_cast<std::uint64_t>(reader->GetOutput()->GetNumberOfPolys());
  report.read = watch.lap();

  vtkNew<vtkQuadricDecimation> filter;
  filter->SetInputData(reader->GetOutput());
  filter->SetTargetReduction(1 - static_cast<double>(arguments.target_faces(report.faces_in)) /
                                     static_cast<double>(report.faces_in));
  filter->Update();
  report.faces_out = static_cast<std::uint64_t>(filter->GetOutput()->GetNumberOfPolys());
  report.simplify = watch.lap();

  vtkNew<vtkPLYWriter> writer;
  writer->SetFileName(arguments.files()[1].c_str());
  writer->SetFileTypeToBinary();
  writer->SetDataByteOrderToLittleEndian();
  writer->SetInputData(filter->GetOutput());
  if (writer->Write() == 0) throw std::runtime_error("cannot write");
  report.write = watch.lap();
  report.json().print();
}

}  // namespace

int main(int argc, char** argv) {
  return bench::guarded("peer_vtk_decimate", [&] {
    run(bench::Arguments(argc, argv, {}, {"--faces", "--ratio"}));
  });
}
