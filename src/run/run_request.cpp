#include "run/run_request.hpp"

#include <winnow/error.hpp>
#include <winnow/options.hpp>

#include "base/checksum.hpp"

#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <type_traits>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winnow {

namespace {

constexpr const char* of_progressive = "progressive";
constexpr const char* of_sequence = "sequence";
constexpr const char* label_count = "labels";
constexpr std::size_t end_bytes = std::size_t{1} << 16;

// Fields of the report.
std::string report_key(const std::string& path) {
  return "report." + path;
}

// A field of one of several results.
std::string level_key(std::string path, std::uint64_t level, const std::string& field) {
  return path.append(".").append(std::to_string(level)).append(".").append(field);
}

class Put {
 public:
  explicit Put(Manifest& manifest) : manifest_(manifest) {}

  template <typename Value>
  void operator()(const std::string& path, const Value& value) {
    if constexpr (std::is_same_v<Value, std::string> || std::is_same_v<Value, double>) {
      manifest_.set(report_key(path), value);
    } else {
      manifest_.set(report_key(path), static_cast<std::uint64_t>(value));
    }
  }
  template <typename Value>
  void operator()(const std::string& path, const std::optional<Value>& value) {
    if (value) (*this)(path, *value);
  }
  void operator()(const std::string& path, const SurfaceEdges& edges) {
    manifest_.set(report_key(path), edges.total);
    manifest_.set(report_key(path) + ".boundary", edges.boundary);
    manifest_.set(report_key(path) + ".non_manifold", edges.non_manifold);
  }
  void operator()(const std::string& path, const std::vector<LevelReport>& levels) {
    manifest_.set(report_key(path), std::uint64_t{levels.size()});
    for (std::size_t i = 0; i < levels.size(); ++i) {
      for_each_level_field(levels[i], [&](const std::string& field, const auto& value) {
        (*this)(level_key(path, i, field), value);
      });
    }
  }
  void operator()(const std::string& path, const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    manifest_.set(report_key(path), text);
  }
  void operator()(const std::string& path, const std::vector<StoppedBy>& reasons) {
    std::vector<std::string> names;
    names.reserve(reasons.size());
    for (const StoppedBy reason : reasons) names.emplace_back(facts_of(reason).name);
    (*this)(path, names);
  }

 private:
  Manifest& manifest_;
};

class Get {
 public:
  explicit Get(const Manifest& manifest) : manifest_(manifest) {}

  template <typename Value>
  void operator()(const std::string& path, Value& value) {
    if constexpr (std::is_same_v<Value, std::string>) {
      value = manifest_.text(report_key(path));
    } else if constexpr (std::is_same_v<Value, double>) {
      value = manifest_.real(report_key(path));
    } else {
      value = static_cast<Value>(manifest_.number(report_key(path)));
      if constexpr (std::is_enum_v<Value>) {
        if (facts_of(value).name == nullptr)
          damaged_checkpoint(manifest_.path(), "'" + report_key(path) + "' is none of its values");
      }
    }
  }
  template <typename Value>
  void operator()(const std::string& path, std::optional<Value>& value) {
    value.reset();
    if (!manifest_.has(report_key(path))) return;
    (*this)(path, value.emplace());
  }
  void operator()(const std::string& path, SurfaceEdges& edges) {
    edges.total = manifest_.number(report_key(path));
    edges.boundary = manifest_.number(report_key(path) + ".boundary");
    edges.non_manifold = manifest_.number(report_key(path) + ".non_manifold");
  }
  void operator()(const std::string& path, std::vector<LevelReport>& levels) {
    levels.clear();
    for (std::uint64_t i = 0; i < manifest_.number(report_key(path)); ++i) {
      for_each_level_field(levels.emplace_back(), [&](const std::string& field, auto& value) {
        (*this)(level_key(path, i, field), value);
      });
    }
  }
  void operator()(const std::string& path, std::vector<std::string>& lines) {
    lines.clear();
    std::istringstream text(manifest_.text(report_key(path)));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
  }
  void operator()(const std::string& path, std::vector<StoppedBy>& reasons) {
    reasons.clear();
    std::vector<std::string> names;
    (*this)(path, names);
    for (const std::string& name : names) {
      for (const StoppedBy reason : all_values<StoppedBy>()) {
        if (facts_of(reason).name == name) reasons.push_back(reason);
      }
    }
  }

 private:
  const Manifest& manifest_;
};

std::string absolute(const std::string& path) {
  return path == "-" ? path : std::filesystem::absolute(path).string();
}

struct Identity {
  std::uint64_t size = 0, modified = 0, ends = 0;
};

std::string input_key(std::size_t i) {
  return "input." + std::to_string(i);
}

std::string label_key(std::size_t i) {
  return "label." + std::to_string(i);
}

std::string option_key(const std::string& name) {
  return "option." + name;
}

template <typename Options>
void put_options(Manifest& manifest, std::span<const Option<Options>> table,
                 const Options& options) {
  for (const Option<Options>& option : table) {
    if (const std::string text = option.get(options); !text.empty())
      manifest.set(option_key(option.name), text);
  }
}

template <typename Options>
void take_options(const Manifest& manifest, std::span<const Option<Options>> table,
                  Options& options) {
  for (const Option<Options>& option : table) {
    const std::string key = option_key(option.name);
    if (!manifest.has(key)) continue;
    try {
      option.set(options, manifest.text(key));
    } catch (const Error&) {
      damaged_checkpoint(manifest.path(), "'" + key + "' is no value of that option");
    }
  }
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

SimplifyOptions reading_options(const ProgressiveOptions& options) {
  SimplifyOptions all;
  all.target = Target::ratio(1);
  all.detail = std::numeric_limits<double>::infinity();
  all.refine = options.refine;
  all.boundary = options.boundary;
  all.topology = options.topology;
  all.attributes = options.attributes;
  all.strict = options.strict;
  all.crop = options.crop;
  all.weld = options.weld;
  all.from = options.from;
  return all;
}

ResumableCall call_in(const Manifest& manifest) {
  if (manifest.has(of_sequence)) return ResumableCall::sequence;
  return manifest.has(of_progressive) ? ResumableCall::progressive : ResumableCall::simplify;
}

const char* command_of(ResumableCall call) {
  switch (call) {
    case ResumableCall::simplify:
      return "simplify";
    case ResumableCall::progressive:
      return "progressive";
    case ResumableCall::sequence:
      return "sequence";
  }
  return "";
}

void put(Manifest& manifest, const RunRequest& request) {
  manifest.set("inputs", std::uint64_t{request.inputs.size()});
  for (std::size_t i = 0; i < request.inputs.size(); ++i)
    manifest.set(input_key(i), absolute(request.inputs[i]));
  manifest.set("output", absolute(request.output));
  if (request.progressive) {
    manifest.set(of_progressive, std::uint64_t{1});
    return put_options(manifest, progressive_options(), *request.progressive);
  }
  if (request.sequence) {
    manifest.set(of_sequence, std::uint64_t{1});
    manifest.set(label_count, std::uint64_t{request.labels.size()});
    for (std::size_t i = 0; i < request.labels.size(); ++i)
      manifest.set(label_key(i), request.labels[i]);
    return put_options(manifest, sequence_options(), *request.sequence);
  }
  SimplifyOptions options = request.options;
  if (!options.map.empty()) options.map = absolute(options.map);
  put_options(manifest, simplify_options(), options);
}

RunRequest request_in(const Manifest& manifest) {
  RunRequest request;
  request.inputs = inputs_in(manifest);
  request.output = manifest.text("output");
  switch (call_in(manifest)) {
    case ResumableCall::simplify:
      take_options(manifest, simplify_options(), request.options);
      break;
    case ResumableCall::progressive:
      take_options(manifest, progressive_options(), request.progressive.emplace());
      request.options = reading_options(*request.progressive);
      break;
    case ResumableCall::sequence:
      take_options(manifest, sequence_options(), request.sequence.emplace());
      for (std::size_t i = 0; i < manifest.number(label_count); ++i)
        request.labels.push_back(manifest.text(label_key(i)));
      break;
  }
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
    throw Error(ErrorKind::bad_input, what + "; remove '" + directory + "' and run `" +
                                          command_of(call_in(manifest)) + "` again");
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
  for_each_result(report, Put(manifest));
}

void get_report(const Manifest& manifest, SimplifyReport& report) {
  for_each_result(report, Get(manifest));
}

void put_report(Manifest& manifest, const SequenceReport& report) {
  for_each_result(report, Put(manifest));
}

void get_report(const Manifest& manifest, SequenceReport& report) {
  for_each_result(report, Get(manifest));
}

}  // namespace winnow
