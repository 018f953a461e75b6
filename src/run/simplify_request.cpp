#include "run/simplify_request.hpp"

#include <winnow/error.hpp>

#include "base/checksum.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <sstream>
#include <type_traits>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

namespace {

constexpr std::size_t end_bytes = std::size_t{1} << 16;

class Put {
 public:
  explicit Put(Manifest& manifest) : manifest_(manifest) {}

  template <typename Value>
  void operator()(const std::string& key, const Value& value) {
    if constexpr (std::is_same_v<Value, std::string> || std::is_same_v<Value, double>) {
      manifest_.set(key, value);
    } else {
      manifest_.set(key, static_cast<std::uint64_t>(value));
    }
  }
  template <typename Value>
  void operator()(const std::string& key, const std::optional<Value>& value) {
    if (value) (*this)(key, *value);
  }
  void operator()(const std::string& key, const std::array<std::array<double, 3>, 2>& box) {
    manifest_.set(key, std::uint64_t{1});
    for (std::size_t i = 0; i < 6; ++i)
      manifest_.set(key + "." + std::to_string(i), box[i / 3][i % 3]);
  }
  void operator()(const std::string& key, const SimplifyReport::Topology::Edges& edges) {
    manifest_.set(key, edges.total);
    manifest_.set(key + ".boundary", edges.boundary);
    manifest_.set(key + ".non_manifold", edges.non_manifold);
  }
  void operator()(const std::string& key, const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    manifest_.set(key, text);
  }

 private:
  Manifest& manifest_;
};

class Get {
 public:
  explicit Get(const Manifest& manifest) : manifest_(manifest) {}

  template <typename Value>
  void operator()(const std::string& key, Value& value) {
    if constexpr (std::is_same_v<Value, std::string>) {
      value = manifest_.text(key);
    } else if constexpr (std::is_same_v<Value, double>) {
      value = manifest_.real(key);
    } else {
      value = static_cast<Value>(manifest_.number(key));
    }
  }
  template <typename Value>
  void operator()(const std::string& key, std::optional<Value>& value) {
    value.reset();
    if (!manifest_.has(key)) return;
    (*this)(key, value.emplace());
  }
  void operator()(const std::string& key, std::array<std::array<double, 3>, 2>& box) {
    for (std::size_t i = 0; i < 6; ++i)
      box[i / 3][i % 3] = manifest_.real(key + "." + std::to_string(i));
  }
  void operator()(const std::string& key, SimplifyReport::Topology::Edges& edges) {
    edges.total = manifest_.number(key);
    edges.boundary = manifest_.number(key + ".boundary");
    edges.non_manifold = manifest_.number(key + ".non_manifold");
  }
  void operator()(const std::string& key, std::vector<std::string>& lines) {
    lines.clear();
    std::istringstream text(manifest_.text(key));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
  }

 private:
  const Manifest& manifest_;
};

// Every option: one that is missing here would be forgotten by resume().
template <typename Visit, typename Options>
void visit_options(Visit&& visit, Options& options) {
  static_assert(sizeof(SimplifyOptions) == 336, "an option has come or gone: name it below");
  visit("option.cell", options.cell);
  visit("option.grid", options.grid);
  visit("option.faces", options.faces);
  visit("option.ratio", options.ratio);
  visit("option.error", options.error);
  visit("option.relative_error", options.relative_error);
  visit("option.refine", options.refine);
  visit("option.detail", options.detail);
  visit("option.borders", options.borders);
  visit("option.topology", options.topology);
  visit("option.keep_pieces", options.keep_pieces);
  visit("option.max_normal_deviation", options.max_normal_deviation);
  visit("option.placement", options.placement);
  visit("option.normals", options.normals);
  visit("option.attributes", options.attributes);
  visit("option.no_data", options.no_data);
  visit("option.strict", options.strict);
  visit("option.crop", options.crop);
  visit("option.weld", options.weld);
  visit("option.relative_weld", options.relative_weld);
  visit("option.from", options.from);
  visit("option.to", options.to);
  visit("option.ascii", options.encoding.ascii);
  visit("option.positions", options.encoding.positions);
  visit("option.compression", options.encoding.compression);
  visit("option.up", options.encoding.up);
  visit("option.quantize", options.encoding.quantize);
  visit("option.force", options.force);
}

template <typename Visit, typename Report>
void visit_report(Visit&& visit, Report& report) {
  visit("report.faces", report.input.faces);
  visit("report.vertices", report.input.vertices);
  visit("report.bytes", report.input.bytes);
  visit("report.format", report.input.format);
  visit("report.cropped_faces", report.input.cropped_faces);
  visit("report.degenerate", report.input.bad_faces.degenerate);
  visit("report.non_finite", report.input.bad_faces.non_finite);
  visit("report.out_of_range", report.input.bad_faces.out_of_range);
  visit("report.output_faces", report.output.faces);
  visit("report.output_vertices", report.output.vertices);
  visit("report.output_bytes", report.output.bytes);
  visit("report.position_error", report.output.position_error);
  visit("report.output_name", report.output.name);
  visit("report.output_format", report.output.format);
  visit("report.weld_distance", report.weld.distance);
  visit("report.weld_vertices", report.weld.vertices);
  visit("report.weld_faces", report.weld.faces);
  visit("report.target_faces", report.target_faces);
  visit("report.cost", report.refine.cost);
  visit("report.tiles", report.refine.tiles);
  visit("report.collapses", report.refine.collapses);
  visit("report.max_error", report.refine.max_error);
  visit("report.stopped_by", report.refine.stopped_by);
  visit("report.target_met", report.target_met);
  visit("report.missed_by", report.missed_by);
  visit("report.lost_pieces", report.lost.pieces);
  visit("report.lost_piece_area", report.lost.piece_area);
  visit("report.lost_handles", report.lost.handles);
  visit("report.lost_holes", report.lost.holes);
  visit("report.carried", report.attributes.carried);
  visit("report.dropped", report.attributes.dropped);
  visit("report.ignored", report.attributes.ignored);
  visit("report.input_edges", report.topology.input);
  visit("report.output_edges", report.topology.output);
  visit("report.closed", report.topology.closed);
  visit("report.clustered_first", report.clustered.first);
  visit("report.clustered_reason", report.clustered.reason);
  visit("report.input_area", report.area.input);
  visit("report.output_area", report.area.output);
  visit("report.cell_size", report.cell_size);
  visit("report.split_cells", report.split_cells);
  visit("report.cells", report.cells);
  visit("report.turned_faces", report.turned_faces);
  visit("report.fused_faces", report.fused_faces);
  visit("report.clamped_faces", report.clamped_faces);
  visit("report.error_bound", report.error_bound);
  visit("report.runs", report.runs);
  visit("report.notes", report.notes);
}

std::string absolute(const std::string& path) {
  return path == "-" ? path : std::filesystem::absolute(path).string();
}

struct Identity {
  std::uint64_t size = 0, modified = 0, ends = 0;
};

std::string input_key(std::size_t i) {
  return "input." + std::to_string(i);
}

std::vector<std::string> inputs_in(const Manifest& manifest) {
  std::vector<std::string> inputs;
  for (std::size_t i = 0; i < manifest.number("inputs"); ++i)
    inputs.push_back(manifest.text(input_key(i)));
  return inputs;
}

// Of regular files; looking into a pipe would take away from it.
std::optional<Identity> identity_of(const std::string& input) {
  struct stat status {};
  if (input == "-" || ::stat(input.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  Identity identity;
  identity.size = static_cast<std::uint64_t>(status.st_size);
  identity.modified = static_cast<std::uint64_t>(status.st_mtim.tv_sec) * 1'000'000'000 +
                      static_cast<std::uint64_t>(status.st_mtim.tv_nsec);
  const int fd = ::open(input.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return {};
  std::vector<std::byte> bytes(2 * end_bytes);
  const off_t back = status.st_size > off_t{end_bytes} ? status.st_size - off_t{end_bytes} : 0;
  const ssize_t front = ::pread(fd, bytes.data(), end_bytes, 0);
  const ssize_t behind = ::pread(fd, bytes.data() + end_bytes, end_bytes, back);
  ::close(fd);
  if (front < 0 || behind < 0) return {};
  identity.ends = Checksum::of(bytes);
  return identity;
}

}  // namespace

void put(Manifest& manifest, const SimplifyRequest& request) {
  manifest.set("inputs", std::uint64_t{request.inputs.size()});
  for (std::size_t i = 0; i < request.inputs.size(); ++i)
    manifest.set(input_key(i), absolute(request.inputs[i]));
  manifest.set("output", absolute(request.output));
  visit_options(Put(manifest), request.options);
}

SimplifyRequest request_in(const Manifest& manifest) {
  SimplifyRequest request;
  request.inputs = inputs_in(manifest);
  request.output = manifest.text("output");
  visit_options(Get(manifest), request.options);
  return request;
}

void put_inputs(Manifest& manifest, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::optional<Identity> identity = identity_of(inputs[i]);
    if (!identity) continue;
    manifest.set(input_key(i) + ".size", identity->size);
    manifest.set(input_key(i) + ".modified", identity->modified);
    manifest.set(input_key(i) + ".ends", identity->ends);
  }
}

bool inputs_are_files(const Manifest& manifest) {
  for (std::size_t i = 0; i < manifest.number("inputs"); ++i) {
    if (!manifest.has(input_key(i) + ".size")) return false;
  }
  return true;
}

void check_inputs(const Manifest& manifest, bool read, const std::string& directory) {
  const std::vector<std::string> inputs = inputs_in(manifest);
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorKind::bad_input,
                what + "; remove '" + directory + "' and run winnow simplify again");
  };
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string key = input_key(i);
    if (!manifest.has(key + ".size")) {
      if (read) continue;
      refuse("the run in '" + directory +
             "' was killed before it had read all of its input, which was a pipe and cannot be "
             "read again");
    }
    const std::optional<Identity> now = identity_of(inputs[i]);
    if (!now) {
      if (read) continue;
      refuse("'" + inputs[i] + "', the input of the run in '" + directory +
             "', is not there or cannot be read any more");
    }
    if (now->size != manifest.number(key + ".size") ||
        now->modified != manifest.number(key + ".modified") ||
        now->ends != manifest.number(key + ".ends"))
      refuse("'" + inputs[i] + "' has changed since the run in '" + directory + "' began with it");
  }
}

void put_report(Manifest& manifest, const SimplifyReport& report) {
  visit_report(Put(manifest), report);
}

void get_report(const Manifest& manifest, SimplifyReport& report) {
  visit_report(Get(manifest), report);
}

}  // namespace winnow
