// Writes a shape on which simplifiers go wrong, as a PLY, and says what a right result keeps.
//
//   bench_shapes NAME OUT.ply [KEY=NUMBER ...] [turn=RADIANS] [double=1]
//   bench_shapes list
//
// Prints a line of JSON: faces, area, and volume (null where the shape is not closed).
#include "support/shapes.hpp"

#include "support/shape_files.hpp"
#include "support/shape_measures.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using winnow::test::Numbers;
using winnow::test::Shape;
namespace shapes = winnow::test::shapes;

// Numbers of a shape in the order of its keys.
class Values {
 public:
  explicit Values(std::vector<double> values) : values_(std::move(values)) {}
  [[nodiscard]] double real(std::size_t i) const { return values_.at(i); }
  [[nodiscard]] std::size_t count(std::size_t i) const { return static_cast<std::size_t>(real(i)); }

 private:
  std::vector<double> values_;
};

struct Maker {
  const char* name;
  std::vector<std::pair<std::string, double>>
      usual;  // keys, and what they are where nothing is said
  Shape (*make)(const Values&);
};

using V = const Values&;
const std::vector<Maker> makers{
    {"thin_shell",
     {{"n", 400}, {"wall", 0.01}},
     [](V v) { return shapes::thin_shell(v.count(0), v.real(1)); }},
    {"plate",
     {{"n", 300}, {"thickness", 0.001}},
     [](V v) { return shapes::plate(v.count(0), v.real(1)); }},
    {"ball_on_ground",
     {{"n", 32}, {"cells", 30}, {"side", 1000}},
     [](V v) { return shapes::ball_on_ground(v.count(0), v.count(1), v.real(2)); }},
    {"room", {{"n", 24}, {"bust", 32}}, [](V v) { return shapes::room(v.count(0), v.count(1)); }},
    {"pipe",
     {{"sides", 12}, {"rings", 400}, {"length", 1000}},
     [](V v) { return shapes::pipe(v.count(0), v.count(1), v.real(2)); }},
    {"capped_cylinder",
     {{"sides", 25'000}},
     [](V v) { return shapes::capped_cylinder(v.count(0)); }},
    {"open_fan", {{"n", 100'000}}, [](V v) { return shapes::open_fan(v.count(0)); }},
    {"book", {{"pages", 1000}}, [](V v) { return shapes::book(v.count(0)); }},
    {"hub", {{"n", 100'000}, {"seed", 1}}, [](V v) { return shapes::hub(v.count(0), v.count(1)); }},
    {"line", {{"n", 400'000}}, [](V v) { return shapes::line(v.count(0)); }},
    {"soup",
     {{"n", 100'000}, {"size", 1}, {"seed", 1}},
     [](V v) { return shapes::soup(v.count(0), v.real(1), v.count(2)); }},
    {"jittered_soup",
     {{"n", 20}, {"jitter", 1e-6}, {"seed", 1}},
     [](V v) { return shapes::jittered_soup(v.count(0), v.real(1), v.count(2)); }},
    {"crowd",
     {{"faces", 1'000'000}, {"vertices", 2000}, {"seed", 1}},
     [](V v) { return shapes::crowd(v.count(0), v.count(1), v.count(2)); }},
    {"capped_cube", {{"n", 40}}, [](V v) { return shapes::capped_cube(v.count(0)); }},
    {"cube_with_caps", {{"n", 40}}, [](V v) { return shapes::cube_with_caps(v.count(0)); }},
    {"zero_area_border_square", {}, [](V) { return shapes::zero_area_border_square(); }},
    {"polygon_square", {{"points", 3}}, [](V v) { return shapes::polygon_square(v.count(0)); }},
    {"disc", {{"n", 60}, {"rings", 20}}, [](V v) { return shapes::disc(v.count(0), v.count(1)); }},
    {"strip",
     {{"n", 100}, {"width", 0.02}},
     [](V v) { return shapes::strip(v.count(0), v.real(1)); }},
    {"double_sided", {{"n", 17}}, [](V v) { return shapes::double_sided(v.count(0)); }},
    {"far_vertex",
     {{"n", 100}, {"far", 1e6}, {"used", 1}},
     [](V v) { return shapes::far_vertex(v.count(0), v.real(1), v.count(2) != 0); }},
    {"hills", {{"n", 800}, {"height", 0.1}}, [](V v) {
       return shapes::hills(v.count(0), v.real(1));
     }}};

// Of a word KEY=NUMBER.
std::pair<std::string, double> setting(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals != std::string::npos && equals + 1 < word.size()) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str() + equals + 1, &end);
    if (*end == '\0' && value >= 0 && value < 1e15) return {word.substr(0, equals), value};
  }
  throw std::runtime_error("no KEY=NUMBER: " + word);
}

using Settings = std::vector<std::pair<std::string, double>>;

// Of a key, which is gone then; `usual` where it is not there.
double take(Settings& settings, const std::string& key, double usual) {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [&](const auto& one) { return one.first == key; });
  if (found == settings.end()) return usual;
  const double value = found->second;
  settings.erase(found);
  return value;
}

Shape make_shape(const std::string& name, Settings settings) {
  const auto maker =
      std::find_if(makers.begin(), makers.end(), [&](const Maker& m) { return m.name == name; });
  if (maker == makers.end()) throw std::runtime_error("no such shape: " + name);
  std::vector<double> values;
  for (const auto& [key, usual] : maker->usual) values.push_back(take(settings, key, usual));
  if (!settings.empty()) throw std::runtime_error("no such key: " + settings.front().first);
  return maker->make(Values(values));
}

void list() {
  for (const Maker& maker : makers) {
    std::cout << maker.name;
    for (const auto& [key, usual] : maker.usual) std::cout << " " << key << "=" << usual;
    std::cout << "\n";
  }
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 1 && words[0] == "list") {
    list();
    return 0;
  }
  if (words.size() < 2) {
    std::cerr << "bench_shapes NAME OUT.ply [KEY=NUMBER ...] [turn=RADIANS] [double=1]\n"
                 "bench_shapes list\n";
    return 2;
  }
  Settings settings;
  for (std::size_t i = 2; i < words.size(); ++i) settings.push_back(setting(words[i]));
  const double angle = take(settings, "turn", 0);
  const Numbers numbers = take(settings, "double", 0) != 0 ? Numbers::doubles : Numbers::floats;
  const Shape shape = turned(make_shape(words[0], settings), angle);
  std::ofstream file(words[1], std::ios::binary);
  file << ply_of(shape, numbers);
  if (!file.flush()) throw std::runtime_error("cannot write " + words[1]);
  const std::optional<double> enclosed = volume(shape);
  std::printf("{\"faces\": %zu, \"area\": %.17g, \"volume\": ", shape.faces.size(), area(shape));
  if (enclosed) {
    std::printf("%.17g}\n", *enclosed);
  } else {
    std::printf("null}\n");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "bench_shapes: " << error.what() << "\n";
    return 1;
  }
}
